import { clientIs, topicArrives, valueAtLeast, valueIs } from '../model/checks.ts';
import type { Lesson } from '../model/lesson.ts';

/** Name and topics of the lesson's program, the same as in `first-program.mjs`. */
export const PROGRAM_NAME = 'first program';
export const WAVE_TOPIC = '/first-program/wave';
export const LAMP_TOPIC = '/first-program/lamp';
export const SEEN_TOPIC = '/first-program/seen';

export const ownProgram: Lesson = {
  id: 'own-program',
  title: 'Your own program',
  heading: 'A program of your own',
  intro:
    'The client library connects a program to the master, in Node and in pages. You will publish from a program and send a value back to it.',
  minutes: 5,
  workspace: { kind: 'program' },
  steps: [
    {
      title: 'Start the program',
      text: 'Install the client library of this master in an empty folder, save the program there, and run it: the commands are below the program. Or run the same calls in this page. The program registers as a client with a name.',
      checks: [
        clientIs(PROGRAM_NAME, true, {
          id: 'client',
          text: 'The client `first program` is connected',
          todo: 'run the program',
        }),
      ],
      answer: { kind: 'program', action: 'run' },
    },
    {
      title: 'Receive its records',
      text: 'The program publishes a wave 20 times a second on `/first-program/wave`. The data format is part of each call: in TypeScript, a value of another format does not compile.',
      checks: [
        topicArrives(({ topics }) => topics.get(WAVE_TOPIC), 5, {
          id: 'arrives',
          text: 'The wave arrives',
          todo: 'keep the program running',
        }),
      ],
      answer: { kind: 'program', action: 'run' },
    },
    {
      title: 'Send a value to it',
      text: 'The program subscribes to `/first-program/lamp` and answers with the number of records that it received on `/first-program/seen`. Publish true with the switch below the program.',
      checks: [
        valueIs(({ topics }) => topics.get(LAMP_TOPIC), 1, {
          id: 'lamp',
          text: 'The lamp is on',
          todo: 'switch the lamp on',
        }),
        valueAtLeast(({ topics }) => topics.get(SEEN_TOPIC), 1, {
          id: 'seen',
          text: 'The program answered',
          todo: 'wait for the answer',
        }),
      ],
      answer: { kind: 'program', action: 'publish' },
    },
    {
      title: 'Stop it',
      text: 'Stop the program with Ctrl+C in the terminal, or with the button. It deregisters: the master deletes its client and the values of its devices, and notifies other clients.',
      checks: [
        clientIs(PROGRAM_NAME, false, {
          id: 'gone',
          text: 'The client has left',
          todo: 'stop the program',
        }),
      ],
      answer: { kind: 'program', action: 'stop' },
    },
  ],
};
