// Viewers that turn together: those inside one `data-linked` element take the angles of the one that hands turn, so
// that a comparison stays one.

export function linkViewers(root: ParentNode): void {
  for (const group of root.querySelectorAll('[data-linked]')) {
    const viewers = [...group.querySelectorAll('phong-viewer')];
    for (const viewer of viewers) {
      viewer.addEventListener('camera-change', (event) => {
        const { source } = (event as CustomEvent<{ source: string }>).detail;
        if (source !== 'pointer' && source !== 'key') return;
        const { theta, phi } = viewer.camera;
        for (const other of viewers) if (other !== viewer) Object.assign(other, { theta, phi });
      });
    }
  }
}
