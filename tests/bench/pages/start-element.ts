// A bundled page with the element: its author wrote the markup and this import.
import 'phong-viewer';
