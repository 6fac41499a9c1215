import type { UbiiClient } from '@ubii/client-web';
import { watch, type Ref } from 'vue';
import type { ClientsStore } from './clients-store.ts';

/** Time within which this page's own name returns as an announcement, milliseconds. */
const ECHO_MS = 5000;

/**
 * Adopts the name that another client gave this page, so that the page uses the name that others see. [EX-29] Ignores
 * announcements of names that this page set itself: otherwise two consecutive ones would alternate forever.
 * @param nowMs this computer's clock
 */
export function adoptName(
  client: Pick<UbiiClient, 'id'>,
  clients: Pick<ClientsStore, 'list' | 'ownName'>,
  name: Ref<string>,
  nowMs: () => number,
): void {
  const said = new Map<string, number>();
  let announced: string | undefined;
  watch(name, (next) => said.set(next, nowMs()), { immediate: true, flush: 'sync' });
  watch(clients.list, () => {
    const own = clients.ownName(client.id);
    if (own === undefined || own === '' || own === announced) return;
    const isFirst = announced === undefined;
    announced = own;
    for (const [text, saidMs] of said) if (nowMs() - saidMs > ECHO_MS) said.delete(text);
    if (!isFirst && own !== name.value && !said.has(own)) name.value = own;
  });
}
