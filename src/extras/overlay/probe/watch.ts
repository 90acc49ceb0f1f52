// Reports the point of `probe-at` where no probe shows it.
import type { Extra, ExtraHost } from '../../../viewer/extra.js';
import { projectionOf, reportProbe } from '../drawing/projection.js';

export function create(host: ExtraHost): Extra {
  const { viewer, values } = host;
  let [isGone, isBusy, again, isReported] = [false, false, false, false];
  const update = (): void => {
    const { probeAt } = values;
    again = isBusy;
    if (isBusy || probeAt === null || host.viewport.frames === 0) return;
    isBusy = true;
    const explained = viewer.explain(probeAt).catch((error: unknown) => {
      if (!isReported) {
        console.warn(`<phong-viewer>: ${(error as Error).message}`);
      }
      isReported = true;
    });
    void explained.then((fragment) => {
      // As in the probe.
      viewer.ownerDocument.defaultView?.requestAnimationFrame(() => {
        isBusy = false;
        if (again && !isGone) {
          update();
        }
      });
      if (isGone || fragment === undefined) return;
      const at = fragment && projectionOf(host.viewport, host.size()).pointInside(probeAt);
      reportProbe(host, fragment, at, true);
    });
  };
  return {
    update,
    dispose() {
      isGone = true;
    },
  };
}
