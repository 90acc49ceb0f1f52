// The element among its peers: a box of its own geometry under one directional light.
import 'phong-viewer';
import { openPeers } from './peer-page.js';

await openPeers({
  tag: 'phong-viewer',
  markup:
    '<phong-viewer geometry="box"><phong-light position="1 2 3 0" diffuse="200"></phong-light></phong-viewer>',
  loaded: (viewer) => (viewer as HTMLElementTagNameMap['phong-viewer']).ready,
});
