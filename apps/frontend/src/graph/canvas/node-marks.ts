import { inject, onBeforeUnmount, provide, shallowReactive, watchEffect } from 'vue';
import type { InjectionKey } from 'vue';

/** What is in a node can say about the whole of it. */
export type NodeMark = 'failing' | 'at-rest' | 'missing';

type Marks = Partial<Record<NodeMark, boolean>>;

const MARKS: InjectionKey<Marks> = Symbol('marks of a node');

/**
 * Classes of a node's frame that depend on what is in it. Not by `:has()`: with that, browsers look at
 * the whole node whenever a value in it changes.
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
