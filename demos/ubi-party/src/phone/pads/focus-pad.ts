/** Puts the focus on the button of the round, so that Space plays and does not open the menu again. */
export function focusPad(): void {
  document.querySelector<HTMLElement>('[data-pad]')?.focus({ preventScroll: true });
}
