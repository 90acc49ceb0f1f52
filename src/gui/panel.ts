// placeholder until the panel is there
import type { CreatePanel } from '../element/panel-door.js';
export const createPanel: CreatePanel = () => ({ update: () => undefined, dispose: () => undefined });
