const KEY = 'ubii.start';
const SMART_DEVICE = '/devices/smart-device';

/** Where a phone goes from now on when no page is named: a page this device is used for. */
export function rememberStart(path: string): void {
  localStorage.setItem(KEY, path);
}

/** Held in the hand: touched, and nothing to hover with. */
function isHandheld(): boolean {
  return matchMedia('(pointer: coarse) and (not (any-hover: hover))').matches;
}

/**
 * Where somebody goes who named no page: with a phone to what it was used for the last time, the first time
 * to the smart device; with everything else home.
 *
 * @param mayBeDevice false where the role lets nobody be a device
 */
export function startPath(mayBeDevice = true): string {
  if (!mayBeDevice || !isHandheld()) return '/';
  return localStorage.getItem(KEY) ?? SMART_DEVICE;
}
