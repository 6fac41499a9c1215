/** Message between tabs of one browser about a device. */
type Word =
  /** This tab is in the foreground. */
  | 'front'
  /** This tab is not, or no longer, in the foreground: asks whether another one is. */
  | 'who'
  /** This tab is inactive, because another one is in the foreground. */
  | 'rests'
  /** This tab is no longer the device. */
  | 'gone';

/** The part of BroadcastChannel that is used. */
export interface TabChannel {
  postMessage(word: string): void;
  onmessage: ((event: MessageEvent) => unknown) | null;
  close(): void;
}

/** Callbacks and channel of a tab. */
export interface FrontTabOptions {
  /** Reaches the other tabs of the browser with the same device. */
  readonly channel: TabChannel;
  readonly isVisible: () => boolean;
  /** Called with whether this tab must be inactive. */
  readonly handleResting: (isResting: boolean) => void;
  /** Called with whether another tab is inactive because of this one. */
  readonly handleOther: (hasOther: boolean) => void;
}

/**
 * Ensures that a page opened twice on one phone is one device: the tab in the foreground is the device, and a hidden
 * one is inactive until it is in the foreground again. Two visible windows are two devices. A hidden tab stays active
 * while no other is in the foreground. [CL-45]
 */
export class FrontTab {
  readonly #options: FrontTabOptions;
  #isResting = false;
  #hasEnded = false;

  constructor(options: FrontTabOptions) {
    this.#options = options;
    options.channel.onmessage = ({ data }) => this.#handle(data as Word);
    this.handleVisibility();
  }

  /** Handles a change of the tab's visibility. */
  handleVisibility(): void {
    // A page that is unloaded becomes hidden afterwards.
    if (this.#hasEnded) return;
    const isVisible = this.#options.isVisible();
    if (isVisible) this.#rest(false);
    this.#say(isVisible ? 'front' : 'who');
  }

  /** The tab is no longer the device; idempotent. */
  end(): void {
    if (this.#hasEnded) return;
    this.#hasEnded = true;
    const { channel } = this.#options;
    channel.onmessage = null;
    this.#say('gone');
    channel.close();
  }

  #handle(word: Word): void {
    const { isVisible, handleOther } = this.#options;
    switch (word) {
      case 'front':
        handleOther(false);
        if (isVisible()) return;
        this.#rest(true);
        this.#say('rests');
        return;
      case 'who':
        if (isVisible()) this.#say('front');
        return;
      case 'rests':
        handleOther(isVisible());
        return;
      case 'gone':
        handleOther(false);
        // If yet another tab is in the foreground, it answers.
        this.#rest(false);
        if (!isVisible()) this.#say('who');
        return;
    }
  }

  #rest(isResting: boolean): void {
    if (this.#isResting === isResting) return;
    this.#isResting = isResting;
    this.#options.handleResting(isResting);
  }

  #say(word: Word): void {
    this.#options.channel.postMessage(word);
  }
}
