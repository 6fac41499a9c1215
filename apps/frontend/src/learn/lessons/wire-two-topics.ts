import { moduleRuns, sessionRuns, topicArrives, valuesMirror } from '../model/checks.ts';
import type { Lesson } from '../model/lesson.ts';
import { outputOf, pointerOf } from './topics.ts';

const mirrored = outputOf('mirrored');

export const wireTwoTopics: Lesson = {
  id: 'wire-two-topics',
  title: 'Wire two topics',
  heading: 'Wire two topics',
  intro:
    'A session takes values from topics, processes them with modules, and publishes the results on other topics. You will mirror the pointer of this browser.',
  minutes: 3,
  workspace: { kind: 'graph', graph: 'mirror', phones: false },
  steps: [
    {
      title: 'Move the pointer',
      text: 'The left node of the graph is a topic: the pointer of this browser. Move the pointer across the page. The node shows the newest position, 0 to 1 on both axes.',
      checks: [
        topicArrives(pointerOf, 5, {
          id: 'pointer',
          text: 'The pointer arrives on its topic',
          todo: 'move the pointer',
        }),
      ],
      answer: { kind: 'move-pointer' },
    },
    {
      title: 'Wire it to the module and start',
      text: 'Drag from the socket at the right of the topic to the input `pointer` of the module. Then press Start at the bottom left. The module runs whenever a position arrives.',
      checks: [
        sessionRuns({ id: 'running', text: 'The session runs', todo: 'press Start' }),
        moduleRuns('mirror-pointer', 1, {
          id: 'module',
          text: 'The module runs while the pointer moves',
          todo: 'wire the pointer, press Start, move the pointer',
        }),
      ],
      answer: { kind: 'graph', edit: 'wire-in' },
    },
    {
      title: 'Wire the result to a topic',
      text: 'Drag from the output `mirrored` to the topic at the right. The change applies at once while the session runs, and nothing restarts.',
      checks: [
        topicArrives(mirrored, 1, {
          id: 'arrives',
          text: 'The result arrives on its topic',
          todo: 'wire the output',
        }),
      ],
      answer: { kind: 'graph', edit: 'wire-out' },
    },
    {
      title: 'Mirror it',
      text: 'An input without a wire takes a fixed value. Set `mirrorX` on the module to true. Where the pointer is at 0.2, the result is now at 0.8.',
      checks: [
        valuesMirror(pointerOf, mirrored, {
          id: 'mirrors',
          text: 'x and mirrored x add up to 1',
          todo: 'set mirrorX',
        }),
      ],
      answer: { kind: 'graph', edit: 'mirror' },
    },
  ],
};
