// @vitest-environment happy-dom
import { jpegFile } from '@ubii/pictures/testing';
import { flushPromises } from '@vue/test-utils';
import { afterAll, afterEach, beforeEach, expect, test, vi } from 'vitest';
import type { Feedback, Question } from '../../sim/index.ts';
import { FEEDBACK, type FakeParty } from '../testing/fake-phone-link.ts';
import { inRound, PhonePage } from '../testing/phone-page.ts';
import { bestFor, type Sighting } from './detector/detector.ts';
import { liveSentence } from './useHunt.ts';

// Files share their modules: what is mocked here is neither there before nor afterwards
vi.hoisted(() => vi.resetModules());
afterAll(() => void vi.resetModules());
vi.mock('./picture.ts', () => ({
  takeStill: ({ width, height }: object & { width: number; height: number }) => ({ width, height }),
  pixelsOf: () => ({ width: 4, height: 3, data: new Uint8ClampedArray(48) }),
  photoOf: (_still: unknown, atMs: number) =>
    Promise.resolve({ jpeg: new Uint8Array(3), width: 4, height: 3, atMs }),
}));

const page = new PhonePage();
const AREA = { x: 0.25, y: 0.25, width: 0.5, height: 0.5 };
const CUP: Sighting = { label: 'cup', score: 0.9, area: AREA };
const BOWL: Sighting = { label: 'bowl', score: 0.95, area: AREA };

const QUESTION: Question = {
  text: 'cup',
  name: 'a cup',
  leastScore: 0.4,
  beganAtMs: 100,
  endsAtMs: 30_100,
  opensAtMs: 100,
  prize: '2nd would be +2',
};

const hunting = (change: Partial<Feedback> = {}): Partial<FakeParty> => ({
  ...inRound('hunt'),
  feedback: {
    ...FEEDBACK,
    headline: 'Find a cup',
    sentence: 'Take a photo of a cup.',
    isReady: true,
    question: QUESTION,
    ...change,
  },
});

let seen: readonly Sighting[];
const closed = vi.fn();
const refuse = (): Promise<MediaStream> =>
  Promise.reject(new DOMException('Permission denied', 'NotAllowedError'));

beforeEach(() => {
  seen = [CUP];
  closed.mockClear();
  vi.stubGlobal('createImageBitmap', () =>
    Promise.resolve({ width: 40, height: 30, close: () => undefined }),
  );
  Object.defineProperty(navigator, 'mediaDevices', {
    value: { getUserMedia: refuse },
    configurable: true,
  });
});
afterEach(() => {
  delete (navigator as { mediaDevices?: unknown }).mediaDevices;
});

/** Opens the page with a detector that sees what the test says. */
async function open(party: Partial<FakeParty>) {
  const detector = { detect: () => Promise.resolve(seen), close: closed };
  const link = page.open(party, {
    openDetector: () => Promise.resolve(detector),
    cameraHelp: (name: string) => `Camera: ${name}.`,
  });
  await vi.dynamicImportSettled();
  await flushPromises();
  return link;
}

async function handIn(file = jpegFile(40, 30)): Promise<void> {
  const input = page.get('input[type=file]');
  Object.defineProperty(input.element, 'files', {
    value: [new File([file], 'cup.jpg')],
    configurable: true,
  });
  await input.trigger('change');
  await flushPromises();
}

test('a picture is looked at on the phone, and only what it shows is handed in', async () => {
  const link = await open(hunting());
  expect(page.text).toContain('Find a cup');
  expect(page.text).toContain('2nd would be +2');
  await handIn();
  expect(link.answers).toEqual([
    { text: '', score: 0, atMs: 1_000_000 },
    { text: 'cup', score: 0.9, atMs: 1_000_000 },
  ]);
  expect(link.photos.filter((photo) => photo !== undefined)).toEqual([]);
});

test('a detector that did not load can be loaded again during the hunt', async () => {
  const detector = { detect: () => Promise.resolve(seen), close: closed };
  const openDetector = vi
    .fn()
    .mockRejectedValueOnce(new Error('onCreated waited too long.'))
    .mockResolvedValue(detector);
  page.open(hunting(), { openDetector, cameraHelp: () => '' });
  await vi.dynamicImportSettled();
  await flushPromises();
  expect(page.get('.plate').text()).toContain('The detector did not load');
  expect(page.text).not.toContain('onCreated');
  expect(page.button('Take the photo').attributes('disabled')).toBeDefined();
  await page.button('Load the detector again').trigger('click');
  await flushPromises();
  expect(page.get('.plate').text()).not.toContain('The detector did not load');
  expect(page.button('Take the photo').attributes('disabled')).toBeUndefined();
});

test('a player who shows photos sends them, and ends them with the switch', async () => {
  const link = await open(hunting());
  const shows = page.button('Show my photos on the big screen');
  expect(shows.attributes('aria-checked')).toBe('false');
  await shows.trigger('click');
  await handIn();
  expect(link.photos.at(-1)).toMatchObject({ width: 4, atMs: 1_000_000 });
  expect(link.answers.at(-1)).toMatchObject({ text: 'cup', area: AREA });
  await shows.trigger('click');
  await flushPromises();
  expect(link.photos.at(-1)).toBeUndefined();
  expect(localStorage.getItem('ubii.party.shows-photos')).toBe('false');
});

test('a photo ends with its thing, and with the round', async () => {
  localStorage.setItem('ubii.party.shows-photos', 'true');
  const link = await open(hunting());
  await handIn();
  expect(link.photos.at(-1)).toBeDefined();
  link.set(hunting({ question: { ...QUESTION, beganAtMs: 40_000, text: 'book', name: 'a book' } }));
  await flushPromises();
  expect(link.photos.at(-1)).toBeUndefined();
  await handIn();
  link.set({ room: { ...link.party.room, phase: 'podium' } });
  await flushPromises();
  expect(link.photos.at(-1)).toBeUndefined();
  expect(closed).toHaveBeenCalledOnce();
});

test('a picture with nothing in it is handed in as nothing', async () => {
  seen = [];
  const link = await open(hunting());
  await handIn();
  expect(link.answers.at(-1)).toMatchObject({ text: 'nothing', score: 0 });
});

test('a file of more pixels than a photo has is not decoded [EX-98]', async () => {
  const decode = vi.fn();
  vi.stubGlobal('createImageBitmap', decode);
  await open(hunting());
  await handIn(jpegFile(20_000, 20_000, { scanBytes: 9 }));
  expect(decode).not.toHaveBeenCalled();
  expect(page.text).toContain('A picture of 20000 × 20000 pixels is too large.');
});

test('without a camera the page says what to do, and pictures can be handed in', async () => {
  await open(hunting());
  expect(page.text).toContain('Camera: NotAllowedError.');
  expect(page.button('Hand in a picture file').attributes('disabled')).toBeUndefined();
});

test('nothing is handed in while a wrong photo costs time', async () => {
  const link = await open(
    hunting({ isReady: false, sentence: 'The phone recognized: bowl, not a cup.' }),
  );
  expect(page.button('Take the photo').attributes('disabled')).toBeDefined();
  expect(page.text).toContain('The phone recognized: bowl');
  expect(link.answers).toEqual([]);
});

test('the explanation asks for the camera and whether photos are shown', async () => {
  await open({ ...inRound('hunt', 'explanation') });
  expect(page.text).toContain('The detector is ready');
  expect(page.button('Turn on the camera').exists()).toBe(true);
  await page.button('Turn on the camera').trigger('click');
  await flushPromises();
  expect(page.text).toContain('Camera: NotAllowedError.');
  expect(page.button('Show my photos').attributes('aria-checked')).toBe('false');
});

test('the live sentence says what the detector sees', () => {
  expect(liveSentence(QUESTION, CUP)).toBe('That’s a cup. Take it!');
  expect(liveSentence(QUESTION, BOWL)).toBe('That’s a bowl, not a cup');
  expect(liveSentence(QUESTION, undefined)).toBe('Looking for a cup');
});

test('the wanted thing counts, also beside something that is seen more surely', () => {
  expect(bestFor(QUESTION, [BOWL, CUP])).toBe(CUP);
  expect(bestFor(QUESTION, [BOWL, { ...CUP, score: 0.3 }])).toBe(BOWL);
  expect(bestFor(QUESTION, [{ ...CUP, score: 0.3 }])).toBeUndefined();
});
