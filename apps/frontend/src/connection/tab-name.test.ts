import { ClientState, type Client } from '@ubii/proto';
import { afterEach, expect, it } from 'vitest';
import { effectScope, nextTick, ref, shallowRef, type EffectScope } from 'vue';
import { useTabName, type TabNumber } from './tab-name.ts';

const scopes: EffectScope[] = [];
afterEach(() => scopes.splice(0).forEach((scope) => scope.stop()));

/** Creates a tab of a browser named Amber Newt, on a master with other clients. */
function tab(id: string, stored: TabNumber | undefined = undefined, name = ref('Amber Newt')) {
  const list = shallowRef<readonly Client[]>();
  const number = ref(stored);
  const scope = effectScope();
  scopes.push(scope);
  const clients = {
    list,
    ownName: (of: string) => list.value?.find((one) => one.id === of)?.name,
  };
  const shown = scope.run(() => useTabName({ id }, clients, name, number))!;
  return {
    shown,
    name,
    number,
    hear: async (...others: readonly [id: string, name: string, state?: ClientState][]) => {
      list.value = others.map(
        ([other, called, state = ClientState.ACTIVE]) =>
          ({ id: other, name: called, state }) as Client,
      );
      await nextTick();
    },
  };
}

it('a tab with a name of its own has no number', async () => {
  const { shown, hear } = tab('a');
  await hear(['a', 'Amber Newt'], ['b', 'Ben']);
  expect(shown.value).toBe('Amber Newt');
});

it('a new tab takes the first free number', async () => {
  const { shown, hear, number } = tab('c');
  await hear(['a', 'Amber Newt'], ['b', 'Amber Newt 2'], ['c', 'Amber Newt']);
  expect(shown.value).toBe('Amber Newt 3');
  expect(number.value).toEqual({ clientId: 'c', number: 3 });
});

it('a tab that comes back keeps its name, whatever order the clients come back in', async () => {
  const first = tab('a', { clientId: 'a', number: 1 });
  const second = tab('b', { clientId: 'b', number: 2 });
  expect(second.shown.value).toBe('Amber Newt 2');
  await second.hear(['b', 'Amber Newt 2']);
  await first.hear(['b', 'Amber Newt 2'], ['a', 'Amber Newt']);
  expect([first.shown.value, second.shown.value]).toEqual(['Amber Newt', 'Amber Newt 2']);
});

it('a client that lost its connection does not take a name', async () => {
  const { shown, hear } = tab('b');
  await hear(['a', 'Amber Newt', ClientState.UNAVAILABLE], ['b', 'Amber Newt']);
  expect(shown.value).toBe('Amber Newt');
});

it('a duplicated tab, which is another client, takes a number of its own', async () => {
  const { shown, hear } = tab('copy', { clientId: 'a', number: 1 });
  await hear(['a', 'Amber Newt'], ['copy', 'Amber Newt']);
  expect(shown.value).toBe('Amber Newt 2');
});

it('renaming the tab renames the browser, without the number', async () => {
  const { shown, name } = tab('b', { clientId: 'b', number: 2 });
  shown.value = 'Ada';
  expect([name.value, shown.value]).toEqual(['Ada', 'Ada 2']);
  shown.value = 'Ben 2';
  expect([name.value, shown.value]).toEqual(['Ben', 'Ben 2']);
});
