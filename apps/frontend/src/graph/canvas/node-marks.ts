import { inject, onBeforeUnmount, provide, shallowReactive, watchEffect } from 'vue';
import type { InjectionKey } from 'vue';

/** State of a node that is set by the views inside it. */
export type NodeMark = 'failing' | 'warned' | 'at-rest' | 'missing';

type Marks = Partial<Record<NodeMark, boolean>>;

const MARKS: InjectionKey<Marks> = Symbol('marks of a node');

/**
 * CSS classes of a node's border that depend on its contents. Not by `:has()`, for which browsers check the whole node
 * whenever a value in it changes.
 */
export function provideNodeMarks(): Readonly<Marks> {
  const marks = shallowReactive<Marks>({});
  provide(MARKS, marks);
  return marks;
}

export function useNodeMarks(marksOf: () => Marks): void {
  const marks = inject(MARKS, {});
  watchEffect(() => Object.assign(marks, marksOf()));
  onBeforeUnmount(() => {
    for (const name of Object.keys(marksOf()) as NodeMark[]) marks[name] = false;
  });
}
