import type { TestKind } from '../measure/findings.ts';

export const TEST_TITLES: Readonly<Record<TestKind, string>> = {
  'round-trip': 'Round trip',
  load: 'Message load',
  'session-speed': 'Session speed',
  screen: 'Topic to screen',
};

/** What a test answers, and how, in plain words. */
export const TEST_ABOUT: Readonly<Record<TestKind, { question: string; how: string }>> = {
  'round-trip': {
    question: 'How long does a value take to the master and back to this browser?',
    how: 'This page publishes numbered values at a steady rate, subscribes to them, and times each until it is back.',
  },
  load: {
    question: 'How many records a second get through before they begin to be late?',
    how: 'Several clients publish faster and faster in a worker of this page, until latency rises or records are lost. The last rate before that is the knee.',
  },
  'session-speed': {
    question: 'How fast do processing modules run, and where?',
    how: 'A temporary session runs the load generator, which adds up Fibonacci numbers. It is removed when the test ends.',
  },
  screen: {
    question: 'How long until a published value is on this screen?',
    how: 'Values are published at odd moments and drawn in the next frame of the page. What the display itself takes comes on top.',
  },
};

export const TEST_ENDS = {
  complete: 'Complete',
  stopped: 'Stopped early',
  disconnected: 'Connection lost',
} as const;
