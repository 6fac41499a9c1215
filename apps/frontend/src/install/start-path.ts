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
 * Returns the default page: on a phone the page it was last used for, the first time
 * to the smart device; with everything else home.
 *
 * @param mayBeDevice false when the role does not allow devices
 */
export function startPath(mayBeDevice = true): string {
  if (!mayBeDevice || !isHandheld()) return '/';
  return localStorage.getItem(KEY) ?? SMART_DEVICE;
}
