import { unrefElement, useEventListener, type MaybeComputedElementRef } from '@vueuse/core';
import { computed, shallowRef, type ShallowRef } from 'vue';
import type { TextFile } from './text-file.ts';

const hasFiles = (event: DragEvent): boolean =>
  event.dataTransfer?.types.includes('Files') === true;

/** Reads files as text. */
export async function readFiles(files: FileList | readonly File[] | null): Promise<TextFile[]> {
  return Promise.all(
    [...(files ?? [])].map(async (file) => ({ name: file.name, text: await file.text() })),
  );
}

/**
 * Handles files dropped on an element or on a component.
 * @returns true while files are dragged over it
 */
export function useFileDrop(
  on: MaybeComputedElementRef,
  onFiles: (files: readonly File[]) => void,
): Readonly<ShallowRef<boolean>> {
  const target = computed(() => unrefElement(on));
  const isOver = shallowRef(false);
  /** Number of nested elements entered, because each one fires its own events. */
  let depth = 0;
  const enter = (by: number): void => {
    depth = Math.max(0, depth + by);
    isOver.value = depth > 0;
  };
  useEventListener(target, 'dragenter', (event: DragEvent) => hasFiles(event) && enter(1));
  useEventListener(target, 'dragleave', (event: DragEvent) => hasFiles(event) && enter(-1));
  useEventListener(target, 'dragover', (event: DragEvent) => {
    if (hasFiles(event)) event.preventDefault();
  });
  useEventListener(target, 'drop', (event: DragEvent) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    enter(-depth);
    onFiles([...(event.dataTransfer?.files ?? [])]);
  });
  return isOver;
}
