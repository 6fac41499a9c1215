// @vitest-environment happy-dom
import { flushPromises, mount } from '@vue/test-utils';
import { expect, test } from 'vitest';
import { nextRoom } from '../sim/index.ts';
import { roomWith } from './testing/fake-phone-link.ts';
import { PhonePage } from './testing/phone-page.ts';
import QrCode from '../tokens/QrCode.vue';

const page = new PhonePage();

test('player joins with a nickname that the phone remembers', async () => {
  const link = page.open();
  expect(page.button('Join').attributes('disabled')).toBeDefined();
  await page.get('input').setValue('  Mara ');
  await page.get('form').trigger('submit');
  await flushPromises();
  expect(link.asked).toEqual([{ type: 'join', name: 'Mara' }]);
  expect(page.get('h1').text()).toBe('Mara');
  page.close();
  page.open();
  expect(page.get('input').element).toMatchObject({ value: 'Mara' });
});

test('refusal of a locked game is shown', async () => {
  const link = page.open();
  await page.get('input').setValue('Mara');
  link.happens({ type: 'lock', by: 'host', on: true });
  await page.get('form').trigger('submit');
  await flushPromises();
  expect(page.get('[role=alert].refusal').text()).toBe(
    'The game is locked. Ask the host to let you in.',
  );
});

test('phone with a code in its address takes over the seat', async () => {
  history.replaceState(null, '', '/party/play#take=7KRM');
  const room = nextRoom(roomWith(9, ['Theo']), { type: 'away', key: 'key-0' }, 5);
  const link = page.open({
    room: { ...room, players: room.players.filter(({ seat }) => seat !== 9) },
  });
  await page.get('form').trigger('submit');
  await flushPromises();
  expect(link.asked).toEqual([{ type: 'take', code: '7KRM' }]);
  expect(page.get('h1').text()).toBe('Theo');
  expect(location.hash).toBe('');
});

test('player who is away is offered, and a wrong code is refused', async () => {
  const room = nextRoom(roomWith(9, ['Theo']), { type: 'away', key: 'key-0' }, 5);
  page.open({ room: { ...room, players: room.players.filter(({ seat }) => seat !== 9) } });
  expect(page.text).toContain('Theo is away.');
  await page.button('Take this seat').trigger('click');
  expect(page.get('h2').text()).toBe('Theo is away. Take this seat?');
  await page.get('input').setValue('aaaa');
  await page.get('form').trigger('submit');
  await flushPromises();
  expect(page.get('.refusal').text()).toBe('No seat is offered with this code.');
});

test('ready goes on and off, and the page has the colour of the seat', async () => {
  const link = page.open({ room: roomWith(1) });
  expect(page.get('.party-phone').attributes('style')).toContain('--page: #2c6be0');
  const ready = page.get('[role=switch]');
  await ready.trigger('click');
  await flushPromises();
  expect([ready.attributes('aria-checked'), ready.text()]).toEqual(['true', 'You are ready']);
  await ready.trigger('click');
  await flushPromises();
  expect(link.asked).toEqual([
    { type: 'ready', isReady: true },
    { type: 'ready', isReady: false },
  ]);
});

test('leader leads from a sheet, others have none', async () => {
  const link = page.open({ room: roomWith(0) });
  await page.button('Host').trigger('click');
  await page.get('input[type=radio][value="2"]').setValue(true);
  await page.button('Photo Hunt').trigger('click');
  await page.button('Lock the game').trigger('click');
  await page.button('Make Ines the leader').trigger('click');
  await flushPromises();
  expect(link.asked).toEqual([
    { type: 'set-teams', teams: 2 },
    { type: 'set-games', games: ['race', 'hill'] },
    { type: 'lock', on: true },
    { type: 'lead', seat: 2 },
  ]);
  expect(page.find('dialog').exists()).toBe(false);
  expect(page.text).toContain('Waiting for Ines to start');
});

test('removing a player is asked once more', async () => {
  const link = page.open({ room: roomWith(0) });
  await page.button('Host').trigger('click');
  await page.button('Remove Theo').trigger('click');
  expect(link.asked).toEqual([]);
  await page.button('Remove Theo now').trigger('click');
  await flushPromises();
  expect(link.asked).toEqual([{ type: 'kick', seat: 1 }]);
});

test('seat is handed over with a code', async () => {
  page.open({ room: roomWith(1) });
  await page.button('Menu').trigger('click');
  await page.button('Move to another phone').trigger('click');
  await expect.poll(() => page.find('svg[role="img"]').exists()).toBe(true);
  expect(page.get('.code').text()).toContain('7KRM');
});

test('seat is handed over at the master that the phone moved to [CU-92]', async () => {
  page.open({ room: roomWith(1), masterUrl: 'http://10.0.0.6:8080' });
  await page.button('Menu').trigger('click');
  await page.button('Move to another phone').trigger('click');
  const text = 'http://10.0.0.6:8080/party/play#take=7KRM';
  const expected = mount(QrCode, { props: { text, label: 'code' } })
    .get('path')
    .attributes('d');
  await expect.poll(() => page.find('svg[role="img"]').exists()).toBe(true);
  expect(page.get('svg[role="img"] path').attributes('d')).toBe(expected);
});

test('player who was removed is told so and can join again', async () => {
  const link = page.open({ room: roomWith(1) });
  link.happens({ type: 'kick', by: 'host', seat: 1 });
  await flushPromises();
  expect(page.get('h1').text()).toBe('You were removed');
  await page.button('Join again').trigger('click');
  expect(page.find('#party-name').exists()).toBe(true);
});

test('phone whose seat has moved is told so', async () => {
  const link = page.open({ room: roomWith(1) });
  link.happens({ type: 'hand-over', key: 'this-phone', to: 'other-phone' });
  await flushPromises();
  expect(page.get('h1').text()).toBe('Your seat moved');
});

test('seat that was free after a lost connection is not called a removal', async () => {
  const link = page.open({ room: roomWith(1) });
  link.set({ link: 'lost' });
  link.set({ link: 'connected' });
  link.happens({ type: 'kick', by: 'host', seat: 1 });
  await flushPromises();
  expect(page.get('h1').text()).toBe('Your seat is free again');
});

test('player who leaves returns to the join screen without a message', async () => {
  const link = page.open({ room: roomWith(1) });
  await page.button('Leave').trigger('click');
  expect(link.asked).toEqual([]);
  await page.button('Leave and lose').trigger('click');
  await flushPromises();
  expect(link.asked).toEqual([{ type: 'leave' }]);
  expect(page.find('#party-name').exists()).toBe(true);
});

test('slow link is told in words', async () => {
  const link = page.open({ room: roomWith(1) });
  expect(page.get('.lag').text()).toContain('24 ms');
  link.set({ lagMs: 148.4 });
  await flushPromises();
  expect(page.get('.lag').text()).toContain('148 ms, slow');
});
