const KEY = 'ubii.start';
const SMART_DEVICE = '/devices/smart-device';

/** Stores the page that a phone opens by default from now on: one that this device was used for. */
export function rememberStart(path: string): void {
  localStorage.setItem(KEY, path);
}

/** True for touch devices without hover. */
function isHandheld(): boolean {
  return matchMedia('(pointer: coarse) and (not (any-hover: hover))').matches;
}

/**
 * Returns the default page: on a phone the page it was last used for, initially the smart device; otherwise the start
 * page.
 *
 * @param mayBeDevice false when the role does not allow devices
 */
export function startPath(mayBeDevice = true): string {
  if (!mayBeDevice || !isHandheld()) return '/';
  return localStorage.getItem(KEY) ?? SMART_DEVICE;
}
