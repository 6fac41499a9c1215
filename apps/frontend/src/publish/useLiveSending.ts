import { onScopeDispose, watch, type Ref } from 'vue';

/** The value of a record and its data format, apart from the topic. */
export interface LiveValue {
  readonly format: string;
  readonly value: unknown;
}

/**
 * Sends while `isOn` when the value changes, at most once per frame. Another topic or data format is not a
 * change of the value.
 */
export function useLiveSending(
  changing: () => LiveValue,
  isOn: Readonly<Ref<boolean>>,
  send: () => void,
): void {
  let frame: number | undefined;
  let before: { readonly format: string; readonly text: string } | undefined;
  watch(
    () => (isOn.value ? changing() : undefined),
    (live) => {
      const next = live && { format: live.format, text: JSON.stringify(live.value) };
      const isValueChange = next && next.format === before?.format && next.text !== before.text;
      before = next;
      if (!isValueChange || frame !== undefined) return;
      frame = requestAnimationFrame(() => {
        frame = undefined;
        if (isOn.value) send();
      });
    },
  );
  onScopeDispose(() => frame !== undefined && cancelAnimationFrame(frame));
}
