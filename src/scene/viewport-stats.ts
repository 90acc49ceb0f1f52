// What drawing one picture costs. Types only; the element documents the fields.

export interface ViewportStats {
  readonly frames: number;
  readonly samples: number;
  readonly lightsActive: number;
  readonly lightsSent: number;
  readonly lightsSentByMesh: readonly number[];
  readonly programs: number;
  readonly drawCalls: number;
  readonly uploads: number;
  readonly viewersDrawn: number;
}
