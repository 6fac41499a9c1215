import { describe, expect, it } from 'vitest';
import { chooseSource, keyOf } from './choose-source.ts';
import { viewerInvitation } from './viewer-words.ts';

const own = { clientId: 'me', isPhone: false, isOwn: true };
const desk = { clientId: 'desk', isPhone: true, isOwn: false };
const anna = { clientId: 'anna', isPhone: true, isOwn: false };
const ben = { clientId: 'ben', isPhone: true, isOwn: false };
const sources = [anna, ben, desk, own];

describe('the source of the rotation', () => {
  it('is the newest phone that publishes its orientation', () => {
    expect(chooseSource(sources, undefined, ['anna', 'ben'])).toBe(ben);
    expect(chooseSource(sources, undefined, ['ben', 'anna'])).toBe(anna);
    expect(chooseSource([desk, own], undefined, ['anna'])).toBe(own);
  });

  it('is this browser while no phone publishes its orientation', () => {
    expect(chooseSource(sources, undefined, [])).toBe(own);
  });

  it('is what the user chose, while it is there', () => {
    expect(chooseSource(sources, keyOf(desk), ['anna'])).toBe(desk);
    expect(chooseSource([anna, own], keyOf(desk), ['anna'])).toBe(anna);
  });
});

describe('the words over the model', () => {
  const viewer = { source: undefined, isOwn: true, hasTurn: true, silent: [], hasPhone: true };
  const phone = { name: 'Anna', isPhone: true };

  it.each([
    ['by hand', viewer],
    ['by hand, without a phone', { ...viewer, hasPhone: false }],
    ['by a phone', { ...viewer, source: phone, isOwn: false }],
    ['by a phone without motion', { ...viewer, source: phone, isOwn: false, hasTurn: false }],
  ])('say that dragging rotates it: %s', (_what, state) => {
    expect(viewerInvitation(state)).toContain('Drag to rotate the model');
  });

  it('name the phone that publishes no motion', () => {
    expect(viewerInvitation({ ...viewer, silent: ['Desk'] })).toContain('Desk publishes no motion');
  });
});
