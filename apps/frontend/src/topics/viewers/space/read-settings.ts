import type { ViewerSettings } from '../topic-viewer.ts';
import type { Up } from './orbit.ts';

/** Settings of a 3D view. */
export interface SpaceSettings {
  readonly up: Up;
  readonly hasTrail: boolean;
  readonly hasNumbers: boolean;
}

export function readSpaceSettings({ up, trail, numbers }: ViewerSettings): SpaceSettings {
  return { up: up === 'z' ? 'z' : 'y', hasTrail: trail !== false, hasNumbers: numbers === true };
}

export function writeSpaceSettings(settings: SpaceSettings): ViewerSettings {
  return { up: settings.up, trail: settings.hasTrail, numbers: settings.hasNumbers };
}
