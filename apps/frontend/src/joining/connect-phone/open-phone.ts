/** Size of the window that simulates a phone, CSS pixels. */
const WIDTH = 390;
const HEIGHT = 844;
/** Path of the page that makes a browser a smart device. */
export const PHONE_PATH = '/devices/smart-device';

/**
 * Opens the device page, or another page for phones, in a window of the size of a phone, as a separate client. With
 * `noopener` it starts with an empty session storage; otherwise it would take the identity of this tab.
 */
export function openPhoneWindow(path = PHONE_PATH): void {
  window.open(path, '_blank', `popup,noopener,width=${WIDTH},height=${HEIGHT}`);
}
