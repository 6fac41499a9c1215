import { inject, type InjectionKey } from 'vue';

/**
 * Returns what a component above provides under `key`.
 *
 * @param provider what has to be there, such as `the graph page above it`
 * @throws Error that names `provider` when nothing is provided
 */
export function injectOrThrow<T>(key: InjectionKey<T>, provider: string): T {
  const value = inject(key, undefined);
  if (value === undefined) throw new Error(`This part needs ${provider}.`);
  return value;
}
