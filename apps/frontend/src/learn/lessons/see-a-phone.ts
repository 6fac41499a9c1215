import { phonesConnected, topicArrives, valueCovers, valueStays } from '../model/checks.ts';
import type { Lesson } from '../model/lesson.ts';
import { touchOf } from './topics.ts';

export const seeAPhone: Lesson = {
  id: 'see-a-phone',
  title: 'See a phone live',
  heading: 'See a phone live',
  intro:
    'A phone becomes an input device as soon as it opens a page. You will touch it and see its values arrive here.',
  minutes: 2,
  workspace: { kind: 'topic' },
  steps: [
    {
      title: 'Connect a phone',
      text: 'A phone needs no app: it opens the page of the smart device. Connect a phone with the button at the top of the page, or open one in this page. The master then lists it as a client.',
      checks: [
        phonesConnected(1, {
          id: 'phone',
          text: 'A phone is connected',
          todo: 'open a phone',
        }),
      ],
      answer: { kind: 'phones', count: 1 },
    },
    {
      title: 'Touch its pad',
      text: 'Put a finger on the pad of the phone and move it. The phone publishes each position on a topic that ends in `touch_position`. A topic is an address with values.',
      checks: [
        topicArrives(touchOf, 5, {
          id: 'arrives',
          text: '`touch_position` arrives',
          todo: 'move a finger on the pad',
        }),
      ],
      answer: { kind: 'touch', gesture: 'circle' },
    },
    {
      title: 'Read the values',
      text: 'The values are of the format `vector2`: `x` from left to right and `y` from top to bottom, both from 0 to 1. Draw a large circle and compare it with the plot.',
      checks: [
        valueCovers(touchOf, 0.5, {
          id: 'covers',
          text: 'x and y change by 0.5 or more',
          todo: 'draw a large circle',
        }),
      ],
      answer: { kind: 'touch', gesture: 'circle' },
    },
    {
      title: 'Lift the finger',
      text: 'Lift the finger and wait a moment. The rate falls to 0 Hz, but the newest value stays: the master retains it. A client that subscribes later receives it at once.',
      checks: [
        valueStays(touchOf, {
          id: 'stays',
          text: 'No records arrive, and the value stays',
          todo: 'lift the finger',
        }),
      ],
      answer: { kind: 'touch', gesture: 'tap' },
    },
  ],
};
