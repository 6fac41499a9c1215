import { describe, expect, it } from 'vitest';
import { FrontTab, type TabChannel } from './front-tab.ts';

/** Tabs of one browser; a message arrives at once at all others. */
class Browser {
  readonly #channels = new Set<TabChannel>();

  open(isVisible: boolean) {
    const state = { isVisible, isResting: false, hasOther: false };
    const channels = this.#channels;
    const channel: TabChannel = {
      onmessage: null,
      postMessage(word) {
        if (!channels.has(channel)) throw new Error('the channel is closed');
        for (const other of channels) {
          if (other !== channel) other.onmessage?.({ data: word } as MessageEvent);
        }
      },
      close: () => void channels.delete(channel),
    };
    channels.add(channel);
    const tab = new FrontTab({
      channel,
      isVisible: () => state.isVisible,
      handleResting: (isResting) => (state.isResting = isResting),
      handleOther: (hasOther) => (state.hasOther = hasOther),
    });
    return {
      state,
      end: () => tab.end(),
      show(isShown: boolean): void {
        state.isVisible = isShown;
        tab.handleVisibility();
      },
    };
  }
}

describe('two tabs of one device [CL-45]', () => {
  it.each(['the new one first', 'the old one first'])(
    'the one in front is the device, the other rests: %s hears of it',
    (order) => {
      const browser = new Browser();
      const first = browser.open(true);
      if (order === 'the old one first') first.show(false);
      const second = browser.open(true);
      if (order === 'the new one first') first.show(false);
      expect(first.state.isResting).toBe(true);
      expect(second.state).toMatchObject({ isResting: false, hasOther: true });

      second.show(false);
      first.show(true);
      expect(first.state).toMatchObject({ isResting: false, hasOther: true });
      expect(second.state).toMatchObject({ isResting: true, hasOther: false });
    },
  );

  it('a hidden one goes on when no other is in front', () => {
    const browser = new Browser();
    const first = browser.open(true);
    first.show(false);
    expect(first.state.isResting).toBe(false);
    const second = browser.open(false);
    expect(second.state.isResting).toBe(false);
  });

  it('goes on when the one in front is closed', () => {
    const browser = new Browser();
    const first = browser.open(false);
    const second = browser.open(true);
    expect(first.state.isResting).toBe(true);
    second.end();
    second.show(false); // As on page unload.
    second.end();
    expect(first.state.isResting).toBe(false);
  });

  it('the one in front hears when the other is closed', () => {
    const browser = new Browser();
    const first = browser.open(false);
    const second = browser.open(true);
    expect(second.state.hasOther).toBe(true);
    first.end();
    expect(second.state).toMatchObject({ isResting: false, hasOther: false });
  });

  it('two windows side by side are two devices', () => {
    const browser = new Browser();
    const [first, second] = [browser.open(true), browser.open(true)];
    expect([first.state, second.state]).toMatchObject([
      { isResting: false, hasOther: false },
      { isResting: false, hasOther: false },
    ]);
  });
});
