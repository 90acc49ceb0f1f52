import 'phong-viewer';
