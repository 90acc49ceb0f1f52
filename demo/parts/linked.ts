// Which viewers turn together? Those inside one `data-linked` element follow the one that the user turns, so that they can be
// compared.

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
