/** Elements that handle letters themselves: fields, and lists and menus with type-ahead. */
const FIELDS =
  'input, textarea, select, [contenteditable]:not([contenteditable="false"]), ' +
  '[role="textbox"], [role="searchbox"], [role="combobox"], [role="spinbutton"], [role="listbox"], ' +
  '[role="menu"], [role="menubar"], [role="dialog"], [role="alertdialog"]';

/** Layers open above the page, even without the focus. */
const OPEN_LAYERS = ['listbox', 'menu', 'dialog', 'alertdialog']
  .map((role) => `[role="${role}"][data-state="open"]`)
  .join(', ');

/** Whether keys on this element are handled by a field, list, menu or dialog around it. */
export function takesKeys(target: EventTarget | null): boolean {
  return (
    target instanceof Element &&
    (target.closest(FIELDS) !== null ||
      (target instanceof HTMLElement && target.isContentEditable === true))
  );
}

/**
 * Whether a key press may trigger a single-key shortcut: without Ctrl, Meta or Alt, not handled yet, and no field,
 * list, menu or dialog has the focus or is open. All single-key shortcuts use this function.
 */
export function isSingleKeyShortcut(event: KeyboardEvent): boolean {
  if (event.ctrlKey || event.metaKey || event.altKey || event.isComposing) return false;
  if (event.defaultPrevented || takesKeys(event.target)) return false;
  return document.querySelector(OPEN_LAYERS) === null;
}
