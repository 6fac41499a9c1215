// Parts of the page that most players do not need, or not yet.

/** The encoder of QR codes. */
export const loadQrCode = () => import('../tokens/QrCode.vue');

/** The screens of a hunt, without its detector. */
export const loadHunt = () => import('./hunt/HuntScreens.vue');

/** Loads them in advance: when the phone continues at another master, they cannot be loaded from the lost one. [CU-92] */
export function loadLaterParts(): void {
  for (const load of [loadQrCode, loadHunt]) void load().catch(() => undefined); // tried again when needed
}
