import { onScopeDispose, toValue, watchEffect, type MaybeRefOrGetter } from 'vue';

import { identityOf, type Seat } from '../../sim/index.ts';

// Deeper paint, not greyer.
const BLACK = '#000000';
const INK = '#221c14';
const PAPER = '#fff6e4';
const TABLE = '#efd6ac';
const YELLOW = '#f7b512';
const BARE_WOOD = '#f6e6c8';

/** The colours of the whole page, all `#rrggbb`. Ink, paper and one yellow on the player's colour. */
export interface PageColours {
  readonly page: string;
  /** Of sentences on the page. */
  readonly text: string;
  /** Shadows on the page. */
  readonly shade: string;
  /** Background of a pad or a ring on the page; paper and accent contrast with it. */
  readonly plate: string;
  /** The player's own piece. */
  readonly token: string;
  readonly onToken: string;
  readonly button: string;
  readonly onButton: string;
  /** Fill of gauges, on a plate or on a button. */
  readonly accent: string;
  /** The button while it is down. */
  readonly pressed: string;
  /** Background of tables, with text in ink. */
  readonly card: string;
}

/** @param seat undefined: the table of the lobby */
export function pageColoursOf(seat: Seat | undefined): PageColours {
  const identity = seat === undefined ? undefined : identityOf(seat);
  const page = identity?.colour ?? TABLE;
  const text = identity?.onColour.sentence ?? INK;
  const isInk = page === INK;
  const isPaper = page === PAPER;
  return {
    page,
    text,
    shade: isInk ? mixed(page, PAPER, 0.12) : mixed(page, BLACK, 0.2),
    plate: isInk ? mixed(page, PAPER, 0.22) : mixed(page, BLACK, text === INK ? 0.62 : 0.48),
    token: isPaper ? INK : PAPER,
    onToken: isPaper ? PAPER : INK,
    button: isInk ? PAPER : INK,
    onButton: isInk ? INK : PAPER,
    accent: page === YELLOW ? PAPER : YELLOW,
    pressed: isInk || isPaper ? YELLOW : PAPER,
    card: isPaper ? BARE_WOOD : PAPER,
  };
}

/** As custom properties for a style. */
export function styleOf(colours: PageColours): Record<string, string> {
  const names = Object.entries(colours).map(([name, colour]) => [dashed(name), colour]);
  return { ...Object.fromEntries(names), '--ink': INK, '--paper': PAPER, '--warn': YELLOW };
}

function dashed(name: string): string {
  return `--${name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`)}`;
}

/** @param share 0: all of the first, 1: all of the second */
function mixed(first: string, second: string, share: number): string {
  const channel = (at: number): string => {
    const [a, b] = [first, second].map((colour) => parseInt(colour.slice(at, at + 2), 16));
    return Math.round(a! + (b! - a!) * share)
      .toString(16)
      .padStart(2, '0');
  };
  return `#${channel(1)}${channel(3)}${channel(5)}`;
}

/** The bars of the browser around the page have its colour, too. */
export function usePageColour(colour: MaybeRefOrGetter<string>): void {
  const meta = document.createElement('meta');
  meta.name = 'theme-color';
  document.head.append(meta);
  watchEffect(() => {
    meta.content = toValue(colour);
    document.documentElement.style.background = toValue(colour);
  });
  onScopeDispose(() => {
    meta.remove();
    document.documentElement.style.removeProperty('background');
  });
}
