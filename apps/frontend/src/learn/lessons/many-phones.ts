import {
  moduleRuns,
  phonesConnected,
  sessionRuns,
  topicsHoldValues,
  valueIs,
} from '../model/checks.ts';
import type { Lesson } from '../model/lesson.ts';
import { outputOf, TOUCH_POSITION } from './topics.ts';

export const manyPhones: Lesson = {
  id: 'many-phones',
  title: 'Many phones',
  heading: 'Many phones, one session',
  intro:
    'A muxer gathers one topic of each client into a list. You will count the fingers that are near one another, on any number of phones.',
  minutes: 5,
  workspace: { kind: 'graph', graph: 'many-phones', phones: true },
  steps: [
    {
      title: 'Connect two phones',
      text: 'Connect two phones, or open them in this page: each is a client of its own with topics of its own. The page shows them beside the graph, one at a time.',
      checks: [
        phonesConnected(2, { id: 'phones', text: 'Two phones are connected', todo: 'open phones' }),
      ],
      answer: { kind: 'phones', count: 2 },
    },
    {
      title: 'Touch both pads',
      text: 'Touch the pad of each phone once. Each publishes its position below its own client id, so the topics have different names and the same end.',
      checks: [
        topicsHoldValues(TOUCH_POSITION, 2, {
          id: 'touched',
          text: 'Two topics `touch_position` hold a value',
          todo: 'touch both pads',
        }),
      ],
      answer: { kind: 'touch', gesture: 'tap' },
    },
    {
      title: 'Start the session',
      text: 'The node at the left is a muxer: its pattern matches `touch_position` of every client, also of those that join later. The module takes the whole list as one input. Press Start.',
      checks: [
        sessionRuns({ id: 'running', text: 'The session runs', todo: 'press Start' }),
        moduleRuns('touch-proximity', 5, {
          id: 'module',
          text: 'The module runs',
          todo: 'wait for its report',
        }),
      ],
      answer: { kind: 'graph', edit: 'start' },
    },
    {
      title: 'Bring two fingers together',
      text: 'Touch the centre of the pad of one phone, then the centre of the other. The module counts positions that are less than 0.2 apart and publishes the count.',
      checks: [
        valueIs(outputOf('near'), 2, {
          id: 'near',
          text: 'Two fingers are near one another',
          todo: 'touch both centres',
        }),
      ],
      answer: { kind: 'touch', gesture: 'tap' },
    },
  ],
};
