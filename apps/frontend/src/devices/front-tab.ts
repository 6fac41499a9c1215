/** What tabs of one browser say to each other about one device. */
type Word =
  /** This tab is in front. */
  | 'front'
  /** This tab is not, or no longer: is another one? */
  | 'who'
  /** This tab rests, because another one is in front. */
  | 'rests'
  /** This tab is the device no more. */
  | 'gone';

/** What is used of a BroadcastChannel. */
export interface TabChannel {
  postMessage(word: string): void;
  onmessage: ((event: MessageEvent) => unknown) | null;
  close(): void;
}

/** What a tab is told. */
export interface FrontTabOptions {
  /** Reaches the other tabs of the browser with the same device, and not this one. */
  readonly channel: TabChannel;
  readonly isVisible: () => boolean;
  /** Whether this tab is to rest. */
  readonly handleResting: (isResting: boolean) => void;
  /** Whether another tab rests because of this one. */
  readonly handleOther: (hasOther: boolean) => void;
}

/**
 * A page opened twice on one phone is one device, not two of which one is dead: the tab in front is the
 * device, and a hidden one rests until it is in front again. Two windows side by side are two devices.
 * A hidden tab with no other in front goes on. [CL-45]
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

  /** The tab came to the front, or left it. */
  handleVisibility(): void {
    // A page that ends is hidden after that.
    if (this.#hasEnded) return;
    const isVisible = this.#options.isVisible();
    if (isVisible) this.#rest(false);
    this.#say(isVisible ? 'front' : 'who');
  }

  /** The tab is the device no more; idempotent. */
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
        // If yet another one is in front, it says so.
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
