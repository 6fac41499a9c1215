import { onScopeDispose, shallowRef, type Ref } from 'vue';
import type { ModuleEntry } from '../../modules/library/module-entry.ts';

/** Estimated height of a card, pixels: texts, and a row per input and output. */
const CARD_WORDS = 150;
const CARD_ROW = 21;
const CARD_DELAY_MS = 350;

/** A module, and the position of its card on the page, pixels. */
export interface ShownCard {
  readonly entry: ModuleEntry;
  readonly left: number;
  readonly top: number;
}

/** Shows the card of a module beside its row, on hover or keyboard focus. */
export function useModuleCard(): {
  readonly card: Readonly<Ref<ShownCard | undefined>>;
  showSoon(event: PointerEvent, entry: ModuleEntry): void;
  showIfKeys(event: FocusEvent, entry: ModuleEntry): void;
  hideCard(): void;
} {
  const card = shallowRef<ShownCard>();
  let waiting: ReturnType<typeof setTimeout> | undefined;
  function hideCard(): void {
    clearTimeout(waiting);
    waiting = undefined;
    card.value = undefined;
  }
  onScopeDispose(hideCard);
  /** Requires a pointer movement: a pointer that is there when the page opens shows no card. */
  function showSoon({ currentTarget, pointerType }: PointerEvent, entry: ModuleEntry): void {
    if (pointerType !== 'mouse' || card.value !== undefined || waiting !== undefined) return;
    waiting = setTimeout(() => showCard(currentTarget as HTMLElement, entry), CARD_DELAY_MS);
  }
  function showIfKeys({ currentTarget }: FocusEvent, entry: ModuleEntry): void {
    const row = currentTarget as HTMLElement;
    if (row.matches(':focus-visible')) showCard(row, entry);
  }
  function showCard(row: HTMLElement, entry: ModuleEntry): void {
    waiting = undefined;
    const { right, top } = row.getBoundingClientRect();
    const { inputs, outputs } = entry.module;
    const height = CARD_WORDS + CARD_ROW * (inputs.length + outputs.length);
    const lowest = window.innerHeight - height;
    card.value = { entry, left: right + 8, top: Math.max(8, Math.min(top - 8, lowest)) };
  }
  return { card, showSoon, showIfKeys, hideCard };
}
