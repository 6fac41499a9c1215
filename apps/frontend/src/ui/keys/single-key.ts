/** Elements that handle letters themselves: fields, and lists and menus with type-ahead. */
const FIELDS =
  'input, textarea, select, [contenteditable]:not([contenteditable="false"]), ' +
  '[role="textbox"], [role="searchbox"], [role="combobox"], [role="spinbutton"], [role="listbox"], ' +
  '[role="menu"], [role="menubar"], [role="dialog"], [role="alertdialog"]';

/** Layers open above the page, even without the focus. */
const OPEN_LAYERS = ['listbox', 'menu', 'dialog', 'alertdialog']
  .map((role) => `[role="${role}"][data-state="open"]`)
  .join(', ');

/**
 * Whether keys on this element are handled by a field, list, menu or dialog around it.
 *
 * @param owner element that the keys are for; dialogs around it are disregarded. @default the page
 */
export function takesKeys(target: EventTarget | null, owner?: Element): boolean {
  if (!(target instanceof Element)) return false;
  const nearest = target.closest(FIELDS);
  if (nearest !== null && !isAround(nearest, owner)) return true;
  return target instanceof HTMLElement && target.isContentEditable === true;
}

const isAround = (layer: Element, owner: Element | undefined): boolean =>
  owner !== undefined && layer.contains(owner);

/**
 * Whether a key press may trigger a single-key shortcut: without Ctrl, Meta or Alt, not handled yet, and no field,
 * list, menu or dialog has the focus or is open. All single-key shortcuts use this function.
 *
 * @param owner element that the key is for; dialogs around it are disregarded. @default the page
 */
export function isSingleKeyShortcut(event: KeyboardEvent, owner?: Element): boolean {
  if (event.ctrlKey || event.metaKey || event.altKey || event.isComposing) return false;
  if (event.defaultPrevented || takesKeys(event.target, owner)) return false;
  return [...document.querySelectorAll(OPEN_LAYERS)].every((layer) => isAround(layer, owner));
}
