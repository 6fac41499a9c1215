import { useLocalStorage } from '@vueuse/core';
import * as v from 'valibot';
import type { Ref } from 'vue';
import { storedAs } from '../../json/read-stored.ts';
import { validElements } from '../../json/schemas.ts';

/** Most favourites; of more, the oldest goes. */
const MAX_FAVOURITES = 100;
const STORED = storedAs(validElements(v.string(), MAX_FAVOURITES), []);

/** Names of the modules that a user marked; stored in this browser. */
export function useFavouriteModules(): {
  readonly names: Readonly<Ref<readonly string[]>>;
  toggle(name: string): void;
} {
  const names = useLocalStorage<string[]>('ubii.favouriteModules', [], { serializer: STORED });
  return {
    names,
    toggle: (name) => (names.value = withToggled(names.value, name)),
  };
}

/** Adds a name, or removes it when it is there. */
export function withToggled(names: readonly string[], name: string): string[] {
  if (names.includes(name)) return names.filter((one) => one !== name);
  return [...names, name].slice(-MAX_FAVOURITES);
}
