// Reports the point of `probe-at` where no probe shows it.
import { zoomOf } from '../../element/dom.js';
import type { ProbeDetail } from '../../element/events.js';
import type { Extra, ExtraHost } from '../../element/viewer/extras.js';
import { projectionOf } from '../drawing/projection.js';

export function create(host: ExtraHost): Extra {
  const { viewer, values } = host;
  let [isGone, isBusy, again] = [false, false, false];
  const update = (): void => {
    const { probeAt } = values;
    again = isBusy;
    if (isBusy || probeAt === null || viewer.stats.frames === 0) return;
    isBusy = true;
    void viewer.explain(probeAt).then((fragment) => {
      isBusy = false;
      if (isGone) return;
      const at = fragment === null ? null : projectionOf(host.viewport, host.size()).pointInside(probeAt);
      const zoom = zoomOf(host.tree.layer);
      const [x, y] = at === null ? [null, null] : [at.x * zoom, at.y * zoom];
      const detail: ProbeDetail = { fragment, x, y, pinned: true };
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
