// @vitest-environment happy-dom
import { ClientState, type Client } from '@ubii/proto';
import { expect, it } from 'vitest';
import { createApp, effectScope, nextTick, shallowRef } from 'vue';
import { CONNECTION } from '../../connection/connection.ts';
import { useJoined } from './useJoined.ts';

const active = (id: string): Client => ({ id, name: id, state: ClientState.ACTIVE }) as Client;

it('lists who joined since it was opened, the newest first, without this browser', async () => {
  const list = shallowRef<readonly Client[]>();
  const app = createApp({ render: () => null });
  app.provide(CONNECTION as symbol, { client: { id: 'own' }, clients: { list } });
  const joined = app.runWithContext(() => effectScope().run(useJoined)!);
  const names = (): string[] => joined.value.map(({ client }) => client.id);

  list.value = [active('before')];
  await nextTick();
  expect(names()).toEqual([]);
  list.value = [active('before'), active('own'), active('Mara')];
  await nextTick();
  expect(names()).toEqual(['Mara']);
  list.value = [active('own'), active('Mara')];
  await nextTick();
  list.value = [active('before'), active('own'), active('Mara')];
  await nextTick();
  expect(names()).toEqual(['Mara']);
});
