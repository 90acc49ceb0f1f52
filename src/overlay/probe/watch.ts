// Reports the point of `probe-at` where no probe shows it.
import type { ProbeDetail } from '../../element/events.js';
import type { Extra, ExtraHost } from '../../element/viewer/extras.js';
import { Projection } from '../drawing/projection.js';

export function create(host: ExtraHost): Extra {
  const { viewer, values } = host;
  const { orbit, fit } = host.viewport.picture;
  let [isGone, isBusy, again] = [false, false, false];
  const update = (): void => {
    const { probeAt } = values;
    again = isBusy;
    if (isBusy || probeAt === null || viewer.stats.frames === 0) return;
    isBusy = true;
    void viewer.explain(probeAt).then((fragment) => {
      isBusy = false;
      if (isGone) return;
      const place = new Projection({ pose: orbit.pose, fov: fit.fov, ...host.size() }).point(probeAt);
      const detail: ProbeDetail = { fragment, x: place?.x ?? null, y: place?.y ?? null, pinned: true };
      viewer.dispatchEvent(new CustomEvent('probe-change', { detail }));
      if (again) update();
    });
  };
  return {
    update,
    dispose() {
      isGone = true;
    },
  };
}
