/** Size of the window that stands in for a phone, CSS pixels. */
const WIDTH = 390;
const HEIGHT = 844;
/** The page that makes a browser a phone. */
export const PHONE_PATH = '/devices/smart-device';

/**
 * Opens the device page, or another page for phones, in a window of the size of a phone, as a client of its own. Without an opener it starts with
 * an empty session storage; else it would take the identity of this tab.
 */
export function openPhoneWindow(path = PHONE_PATH): void {
  window.open(path, '_blank', `popup,noopener,width=${WIDTH},height=${HEIGHT}`);
}
