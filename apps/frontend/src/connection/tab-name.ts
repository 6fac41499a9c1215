import type { UbiiClient } from '@ubii/client-web';
import { ClientState } from '@ubii/proto';
import { computed, watch, type Ref, type WritableComputedRef } from 'vue';
import type { ClientsStore } from './clients-store.ts';

/** Number of a tab among clients of the same name, and the client it was chosen for. */
export interface TabNumber {
  readonly clientId: string;
  readonly number: number;
}

/** `Amber Newt`, `Amber Newt 2`. */
export function numberedName(name: string, number = 1): string {
  return number > 1 ? `${name} ${number}` : name;
}

/**
 * Returns the name under which this tab registers: that of the browser, with a number from the second tab on. A tab
 * keeps its number over reloads and restarts of the master, so that its name is the same on all pages and in logs.
 * Assigning renames the browser.
 *
 * @param name the browser's name, which its tabs share
 * @param chosen number stored for this tab
 */
export function useTabName(
  client: Pick<UbiiClient, 'id'>,
  clients: Pick<ClientsStore, 'list' | 'ownName'>,
  name: Ref<string>,
  chosen: Ref<TabNumber | undefined>,
): WritableComputedRef<string> {
  const stop = watch(clients.list, (list) => {
    if (list === undefined || client.id === '') return;
    // A duplicated tab starts with the session storage of its original.
    if (chosen.value?.clientId !== client.id) {
      const taken = new Set(
        list
          .filter(({ id, state }) => id !== client.id && state !== ClientState.UNAVAILABLE)
          .map(({ id }) => clients.ownName(id)),
      );
      let number = 1;
      while (taken.has(numberedName(name.value, number))) number += 1;
      chosen.value = { clientId: client.id, number };
    }
    stop();
  });

  return computed({
    get: () => numberedName(name.value, chosen.value?.number),
    set(next) {
      const suffix = ` ${chosen.value?.number}`;
      const isNumbered = (chosen.value?.number ?? 1) > 1 && next.endsWith(suffix);
      name.value = isNumbered ? next.slice(0, -suffix.length) : next;
    },
  });
}
