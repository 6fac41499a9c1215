import { flushPromises, mount, type DOMWrapper, type VueWrapper } from '@vue/test-utils';
import { afterEach, beforeEach, vi } from 'vitest';
import type { Phase } from '../../sim/index.ts';
import PartyPhone from '../PartyPhone.vue';
import { FakePhoneLink, FEEDBACK, roomWith, type FakeParty } from './fake-phone-link.ts';

/** The phone's page in a test, with frames that come when the test says so. */
export class PhonePage {
  readonly vibrate = vi.fn(() => true);
  #mounted: VueWrapper | undefined;
  #frames: FrameRequestCallback[] = [];

  constructor() {
    beforeEach(() => {
      localStorage.clear();
      history.replaceState(null, '', '/party/play');
      this.#frames = [];
      this.vibrate.mockClear();
      vi.stubGlobal('requestAnimationFrame', (fn: FrameRequestCallback) => this.#frames.push(fn));
      vi.stubGlobal('cancelAnimationFrame', () => undefined);
      Object.defineProperty(navigator, 'vibrate', { value: this.vibrate, configurable: true });
    });
    afterEach(() => {
      this.close();
      vi.unstubAllGlobals();
      delete (navigator as { vibrate?: unknown }).vibrate;
      localStorage.clear();
    });
  }

  open(party: Partial<FakeParty> = {}, props: object = {}): FakePhoneLink {
    const link = new FakePhoneLink(party);
    this.#mounted = mount(PartyPhone, { props: { link, ...props }, attachTo: document.body });
    return link;
  }

  close(): void {
    this.#mounted?.unmount();
    this.#mounted = undefined;
  }

  /** One animation frame. */
  async frame(): Promise<void> {
    const now = this.#frames;
    this.#frames = [];
    for (const fn of now) fn(16);
    await flushPromises();
  }

  get(selector: string): Omit<DOMWrapper<Element>, 'exists'> {
    return this.#page.get(selector);
  }

  find(selector: string): DOMWrapper<Element> {
    return this.#page.find(selector);
  }

  get text(): string {
    return this.#page.text();
  }

  /** @param name the beginning of its accessible name */
  button(name: string): DOMWrapper<Element> {
    const found = this.#page
      .findAll('button')
      .find((one) => (one.attributes('aria-label') ?? one.text()).startsWith(name));
    if (!found) throw new Error(`No button "${name}" in: ${this.text}`);
    return found;
  }

  get #page(): VueWrapper {
    if (!this.#mounted) throw new Error('The page is not open.');
    return this.#mounted;
  }
}

/** In a round of a game, or on the way to it. */
export function inRound(game: string, phase: Phase = 'play', startsInMs = -1000) {
  return {
    room: { ...roomWith(1), phase, games: [game] },
    round: { id: 'r', game, seed: 1, startsAtMs: 1_000_000 + startsInMs, seats: [0, 1, 2] },
    feedback: FEEDBACK,
  };
}

export const touch = (pointerId: number, clientX: number, clientY: number) => ({
  pointerId,
  clientX,
  clientY,
  button: 0,
});
