// What drawing one picture has cost so far. Types only.

export interface ViewportStats {
  readonly frames: number;
  readonly lightsActive: number;
  readonly lightsSent: number;
  readonly lightsSentByMesh: readonly number[];
  readonly programs: number;
  readonly drawCalls: number;
  readonly uploads: number;
  readonly viewersDrawn: number;
}
