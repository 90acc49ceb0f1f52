// three.js's WebXR, of which a picture inside a page has no use: no session ever begins.

export class WebXRManager {
  enabled = false;
  isPresenting = false;
  cameraAutoUpdate = true;
  addEventListener() {}
  removeEventListener() {}
  setAnimationLoop() {}
  getEnvironmentBlendMode() {}
  hasDepthSensing() {
    return false;
  }
  dispose() {}
}
