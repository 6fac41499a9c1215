import type { Client } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { effectScope, nextTick, ref, shallowRef } from 'vue';
import { adoptName } from './adopt-name.ts';

function setup() {
  const name = ref('Anna');
  const list = shallowRef<readonly Client[]>();
  let now = 0;
  const scope = effectScope();
  scope.run(() =>
    adoptName(
      { id: 'me' },
      { list, ownName: (id) => list.value?.find((one) => one.id === id)?.name },
      name,
      () => now,
    ),
  );
  return {
    name,
    scope,
    later: (ms: number) => (now += ms),
    announce: async (own: string) => {
      list.value = [{ id: 'me', name: own } as unknown as Client];
      await nextTick();
    },
  };
}

describe('adoptName', () => {
  it('adopts the name that another client gave this page [EX-29]', async () => {
    const { name, announce, later, scope } = setup();
    await announce('Anna');
    later(1000);
    await announce('Stage left');
    expect(name.value).toBe('Stage left');
    scope.stop();
  });

  it('does not take echoes of what the page said itself', async () => {
    const { name, announce, scope } = setup();
    await announce('Anna');
    name.value = 'Annabel';
    name.value = 'Annabella';
    await announce('Annabel');
    expect(name.value).toBe('Annabella');
    await announce('Annabella');
    expect(name.value).toBe('Annabella');
    scope.stop();
  });

  it('adopts an earlier name when it is set again later', async () => {
    const { name, announce, later, scope } = setup();
    await announce('Anna');
    name.value = 'Annabel';
    await announce('Annabel');
    later(60_000);
    await announce('Anna');
    expect(name.value).toBe('Anna');
    scope.stop();
  });

  it('leaves the name alone that the master knew before the page said its own', async () => {
    const { name, announce, scope } = setup();
    await announce('Visitor');
    expect(name.value).toBe('Anna');
    scope.stop();
  });
});
