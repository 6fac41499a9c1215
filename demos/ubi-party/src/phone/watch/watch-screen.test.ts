// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { expect, test } from 'vitest';
import type { LiveRound } from '../../net/index.ts';
import { nextRoom, type Phase, type Room } from '../../sim/index.ts';
import { FEEDBACK, roomWith } from '../testing/fake-phone-link.ts';
import { inRound, PhonePage, touch } from '../testing/phone-page.ts';

const page = new PhonePage();

const LIVE: LiveRound = {
  id: 'r',
  headline: '1 standing',
  corner: { value: '3', label: 'outer ring falls' },
  rows: [
    { seat: 2, place: 1, note: 'king 7 s', isOut: false },
    { seat: 0, place: 2, note: '1 push', isOut: true },
  ],
};

/** Theo and Ines play, this phone watches. */
function watched(phase: Phase, change: Partial<Room> = {}) {
  const { room, round } = inRound('hill', phase);
  const players = room.players.filter(({ seat }) => seat !== 1);
  const spectators = [{ key: 'this-phone', name: 'Wim' }];
  return { room: { ...room, players, spectators, ...change }, round, live: LIVE };
}

/** This phone has a seat, and came during the round. */
function waiting(game: string, phase: Phase = 'play') {
  const { room, round } = inRound(game, phase);
  const players = room.players.map((one) => ({ ...one, isWaiting: one.seat === 1 }));
  return { room: { ...room, players }, round, live: LIVE };
}

test('person watches without a name, also a locked game', async () => {
  const link = page.open();
  link.happens({ type: 'lock', by: 'host', on: true });
  await flushPromises();
  expect(page.text).toContain('The game is locked. Ask the host to let you in. You can watch.');
  await page.button('Watch').trigger('click');
  await flushPromises();
  expect(link.asked).toEqual([{ type: 'watch', name: '' }]);
  expect(page.get('.phone-header').text()).toContain('Guest');
  expect(page.button('Take a seat').attributes('disabled')).toBeDefined();
  expect(document.activeElement?.tagName).toBe('H1');
});

test('spectator sees the round with places, scores and who is out or away', async () => {
  const link = page.open(watched('play'));
  expect(page.get('h1').text()).toBe('King of the Hill');
  expect(page.get('.round-board').text()).toContain('3 outer ring falls');
  const rows = page.get('.player-table').findAll('li');
  expect(rows.map((row) => row.text().replace(/\s+/g, ' '))).toEqual([
    '1CInesking 7 s',
    '2ATheoout1 push',
  ]);
  link.happens({ type: 'away', key: 'key-2' });
  await flushPromises();
  expect(page.get('.player-table').text()).toContain('away');
});

test('spectator sees who won, the table, and takes a seat', async () => {
  const party = watched('play');
  const link = page.open(party);
  link.happens({ type: 'round-over', places: [[2], [0]] });
  await flushPromises();
  expect(page.get('h1').text()).toBe('Ines wins');
  expect(page.get('.place-table').findAll('li')).toHaveLength(2);
  await page.button('Take a seat').trigger('click');
  await flushPromises();
  expect(link.asked).toEqual([{ type: 'join', name: 'Wim' }]);
  expect(page.get('h1').text()).toBe('You’re next');
});

test('spectator stops watching silently, and learns of a removal', async () => {
  const link = page.open(watched('lobby'));
  expect(page.text).toContain('2 players. The game has not started.');
  await page.button('Stop watching').trigger('click');
  await flushPromises();
  expect(page.find('#party-name').exists()).toBe(true);
  await page.button('Watch').trigger('click');
  await flushPromises();
  link.happens({ type: 'dismiss', by: 'host', key: 'this-phone' });
  await flushPromises();
  expect(page.get('h1').text()).toBe('You are no longer watching');
});

test('cheers go out one at a time, and the focus stays', async () => {
  const link = page.open(watched('play'));
  const love = page.button('Love it');
  (love.element as HTMLElement).focus();
  await love.trigger('click');
  await page.button('Hooray').trigger('click');
  expect(link.cheers).toEqual(['love']);
  expect(page.button('Hooray').attributes('aria-disabled')).toBe('true');
  expect(document.activeElement).toBe(love.element);
  expect(page.get('.cheer-row [role=status]').text()).toBe('Love it: sent');
});

test('player who is out cheers, others steer', async () => {
  const link = page.open(inRound('hill'));
  expect(page.find('.cheer-row').exists()).toBe(false);
  link.set({ feedback: { ...FEEDBACK, isOut: true } });
  await flushPromises();
  await page.button('Great').trigger('click');
  expect(link.cheers).toEqual(['great']);
  // The fallen vote with the stick
  expect(page.find('.stick-pad').exists()).toBe(true);
});

test('late joiner practises on the phone alone', async () => {
  const link = page.open(waiting('hill'));
  await page.button('Practise the controls').trigger('click');
  expect(document.activeElement?.hasAttribute('data-pad')).toBe(true);
  await page.get('.stick-pad').trigger('pointerdown', touch(1, 100, 600));
  await page.get('.stick-pad').trigger('pointermove', touch(1, 164, 600));
  await page.get('.round-pad').trigger('pointerdown', touch(2, 300, 600));
  await page.frame();
  expect(page.get('h1').text()).toBe('Right 100 %');
  expect(page.text).toContain('Dash is pressed.');
  expect(link.sent).toEqual([]);
  await page.button('Back').trigger('click');
  await flushPromises();
  expect(document.activeElement?.textContent).toContain('Practise the controls');
  expect(link.sent).toEqual([]);
});

test('practice knows one button and the left hand', async () => {
  const settings = { hasOneButton: true, hand: 'left' };
  localStorage.setItem('ubii.party.phone', JSON.stringify(settings));
  page.open(waiting('hill'));
  await page.button('Practise the controls').trigger('click');
  expect(page.get('.play-screen').classes()).toEqual(
    expect.arrayContaining(['for-dial', 'left-hand']),
  );
  await page.frame();
  await page.get('.wide-pad').trigger('pointerdown', touch(1, 100, 700));
  await page.frame();
  expect(page.get('h1').text()).toMatch(/^Up/);
});

test('practice ends with the round, and there is none for a camera', async () => {
  const link = page.open(waiting('hill'));
  await page.button('Practise the controls').trigger('click');
  link.set({
    room: nextRoom({ ...roomWith(1), games: ['hill'] }, { type: 'proceed', by: 'host' }, 0),
  });
  await flushPromises();
  expect(page.text).not.toContain('would send');
  page.close();
  page.open(waiting('hunt'));
  expect(page.text).not.toContain('Practise');
});

test('leader sees who watches, removes one, and chooses a pace', async () => {
  const spectators = ['Wim', 'Guest'].map((name) => ({ key: name, name }));
  const link = page.open({ room: { ...roomWith(0), spectators } });
  await page.button('Host').trigger('click');
  expect(page.text).toContain('2 watching');
  await page.button('Remove Wim').trigger('click');
  expect(link.asked).toEqual([]);
  await page.button('Remove Wim now').trigger('click');
  await page.get('input[type=radio][value="long"]').setValue(true);
  await flushPromises();
  expect(link.asked).toEqual([
    { type: 'dismiss', key: 'Wim' },
    { type: 'set-pace', pace: 'long' },
  ]);
  expect(page.text).toContain('1 watching');
});
