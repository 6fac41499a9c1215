import type { TestKind } from '../measure/findings.ts';

export const TEST_TITLES: Readonly<Record<TestKind, string>> = {
  'round-trip': 'Round trip',
  load: 'Message load',
  'session-speed': 'Session speed',
  screen: 'Topic to screen',
};

/** The question that a test answers, and its method. */
export const TEST_ABOUT: Readonly<Record<TestKind, { question: string; how: string }>> = {
  'round-trip': {
    question: 'How long does a value take from this browser to the master and back?',
    how: 'This page publishes numbered values at a fixed rate, subscribes to them, and measures the time until each is received.',
  },
  load: {
    question: 'How many records per second arrive in time?',
    how: 'Several clients publish faster and faster in a worker of this page, until latency rises or records are lost. The last rate before that is the knee.',
  },
  'session-speed': {
    question: 'How fast do processing modules run, and where?',
    how: 'A temporary session runs the load generator, which adds Fibonacci numbers. It is removed after the test.',
  },
  screen: {
    question: 'How long does a published value take to this screen?',
    how: 'Values are published at irregular times and drawn in the next frame of the page. The delay of the display itself is not included.',
  },
};

export const TEST_ENDS = {
  complete: 'Complete',
  stopped: 'Stopped early',
  disconnected: 'Connection lost',
} as const;
