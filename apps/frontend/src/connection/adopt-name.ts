import type { UbiiClient } from '@ubii/client-web';
import { watch, type Ref } from 'vue';
import type { ClientsStore } from './clients-store.ts';

/** What this page said itself comes back as an announcement within this time, milliseconds. */
const ECHO_MS = 5000;

/**
 * Adopts the name that another client gave this page, so that the page uses the name that others see.
 * [EX-29] Echoes of what it said itself are not taken: two that follow each other would chase forever.
 * @param nowMs this machine's clock
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
