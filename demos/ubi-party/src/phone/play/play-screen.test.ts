// @vitest-environment happy-dom
import { flushPromises } from '@vue/test-utils';
import { expect, test } from 'vitest';
import { FEEDBACK, roomWith } from '../testing/fake-phone-link.ts';
import { inRound, PhonePage, touch } from '../testing/phone-page.ts';

const page = new PhonePage();

test('two thumbs steer and press at once', async () => {
  const link = page.open(inRound('hill'));
  const stick = page.get('.stick-pad');
  const dash = page.get('.round-pad');
  await stick.trigger('pointerdown', touch(1, 100, 600));
  await stick.trigger('pointermove', touch(1, 150, 600));
  await dash.trigger('pointerdown', touch(2, 300, 600));
  expect(link.sent).toEqual([true]);
  expect(dash.classes()).toContain('down');
  expect(page.vibrate).toHaveBeenCalledWith(10);
  await page.frame();
  await stick.trigger('pointermove', touch(1, 164, 600));
  await stick.trigger('pointermove', touch(2, 0, 0));
  await page.frame();
  await page.frame();
  await dash.trigger('pointerup', touch(2, 300, 600));
  await stick.trigger('pointerup', touch(1, 164, 600));
  await page.frame();
  expect(link.sent).toEqual([true, { x: 0.75, y: 0 }, { x: 1, y: 0 }, false, { x: 0, y: 0 }]);
});

test('everything is let go when the page loses the focus', async () => {
  const link = page.open(inRound('race'));
  await page.get('.wheel-pad').trigger('pointerdown', touch(1, 100, 300));
  await page.get('.wheel-pad').trigger('pointermove', touch(1, 300, 300));
  await page.get('.wide-pad').trigger('pointerdown', touch(2, 200, 700));
  await page.frame();
  window.dispatchEvent(new Event('blur'));
  await page.get('.wheel-pad').trigger('pointermove', touch(1, 310, 300));
  await page.frame();
  expect(link.sent).toEqual([true, { x: 1, y: 0 }, false, { x: 0, y: 0 }]);
});

test('keys play, and are let go while the menu is open', async () => {
  const link = page.open(inRound('hill'));
  window.dispatchEvent(new KeyboardEvent('keydown', { code: 'KeyW' }));
  window.dispatchEvent(new KeyboardEvent('keydown', { code: 'Space' }));
  await page.frame();
  await page.button('Pause and menu').trigger('click');
  window.dispatchEvent(new KeyboardEvent('keydown', { code: 'KeyA' }));
  await page.frame();
  expect(link.sent).toEqual([true, { x: 0, y: 1 }, false, { x: 0, y: 0 }]);
});

test('the pad says the seconds of a gauge that is time', () => {
  const feedback = { ...FEEDBACK, gauge: 0.88, secondsLeft: 8 };
  page.open({ ...inRound('quiz'), feedback });
  expect(page.get('.wide-pad').text()).toContain('8 s left');
  expect(page.get('.wide-pad').text()).not.toContain('%');
});

test('one button takes the direction to which the pointer has come', async () => {
  localStorage.setItem('ubii.party.phone', JSON.stringify({ hasOneButton: true }));
  const link = page.open(inRound('hill'));
  await page.frame();
  await page.get('.wide-pad').trigger('pointerdown', touch(1, 100, 700));
  await page.frame();
  expect(link.sent[0]).toBe(true);
  expect(link.sent[1]).toMatchObject({ y: 1 });
});

test('press before the start answers and is not sent', async () => {
  const link = page.open(inRound('duel', 'countdown', 2500));
  expect(page.get('h1').text()).toBe('3');
  await page.get('.wide-pad').trigger('pointerdown', touch(1, 100, 700));
  expect(page.get('.wide-pad').classes()).toContain('down');
  expect(link.sent).toEqual([]);
});

test('standing is read, and a hit is felt, or seen where the phone cannot vibrate', async () => {
  const link = page.open(inRound('race'));
  expect(page.get('.play-standing').text()).toContain('2nd of 6');
  expect(page.get('h1').text()).toBe('Lap 2 of 3');
  link.set({ feedback: { ...FEEDBACK, hitAt: 77 } });
  await flushPromises();
  expect(page.vibrate).toHaveBeenLastCalledWith(60);
  expect(page.find('.hit-flash').exists()).toBe(false);
  page.vibrate.mockReturnValueOnce(false);
  link.set({ feedback: { ...FEEDBACK, hitAt: 99 } });
  await flushPromises();
  expect(page.find('.hit-flash').exists()).toBe(true);
});

test('lost connection is told beside the pads, and its return too', async () => {
  const link = page.open(inRound('race'));
  link.set({ link: 'lost' });
  await flushPromises();
  expect(page.text).toContain('Connection lost. Your seat is kept for 2 minutes.');
  expect(page.find('.wide-pad').exists()).toBe(true);
  link.set({ link: 'connected' });
  await flushPromises();
  expect(page.text).toContain('Connected again.');
});

test('late joiner sees what is played, who plays it, and the table', async () => {
  const { room, ...round } = inRound('race');
  const players = room.players.map((one) => ({ ...one, isWaiting: one.seat === 1, points: 4 }));
  const results = [{ game: 'hill', places: [[0], [2]], points: { 0: 10, 2: 8 } }];
  page.open({ ...round, room: { ...room, players, results, games: ['hill', 'race'] } });
  expect(page.text).toContain('2 play Marble Dash now. You play from the next game on.');
  expect(page.get('.player-table').findAll('li')).toHaveLength(2);
  await page.button('Show the tournament').trigger('click');
  expect(page.get('.place-table').findAll('li')).toHaveLength(3);
});

test('podium has the own place, and ready for the next', async () => {
  const room = { ...roomWith(1), phase: 'play' as const, games: ['race', 'hill'] };
  const link = page.open({ room });
  link.happens({ type: 'round-over', places: [[0], [1], [2]] });
  await flushPromises();
  expect(page.get('h1').text()).toBe('2nd');
  await page.button('Ready for the next').trigger('click');
  expect(link.asked).toEqual([{ type: 'ready', isReady: true }]);
});
