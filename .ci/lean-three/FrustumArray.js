// The fields of view of several cameras at once, as WebXR has them.

export class FrustumArray {}
