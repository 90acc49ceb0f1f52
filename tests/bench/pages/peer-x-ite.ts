// X_ITE among its peers: X3D's own box and light, written in the page. Its script loads the component of boxes by itself.
import { next, openPeers } from './peer-page.js';

await openPeers({
  tag: 'x3d-canvas',
  markup: `<x3d-canvas><X3D profile="Interchange" version="4.0"><Scene>
    <Background transparency="1"></Background>
    <NavigationInfo headlight="false"></NavigationInfo>
    <DirectionalLight direction="-1 -2 -3" intensity="0.8"></DirectionalLight>
    <Viewpoint position="1.1 0.8 1.9" orientation="-0.55 0.83 0.09 0.62"></Viewpoint>
    <Shape>
      <Appearance><Material diffuseColor="1 1 1"></Material></Appearance>
      <Box size="1 1 1"></Box>
    </Shape>
  </Scene></X3D></x3d-canvas>`,
  loaded: (canvas) => next(canvas, 'load'),
});
