import type { HowTo } from './how-to.ts';

/** How-tos for recordings that become live again. */
export const REPLAY_HOW_TOS: readonly HowTo[] = [
  {
    id: 'replay-a-recording',
    title: 'Replay a recording into sessions',
    intro:
      'A replay publishes recorded records again. Running sessions, pages and clients receive them as if they were live, so that you can work on a session without its devices.',
    blocks: [
      {
        kind: 'steps',
        steps: [
          'Open a recording. In the bar with the Play button, change **This page only** to **Live topics**.',
          'Choose **All topics** or **Some topics**, and what happens to live records of the same topics until you stop: **Mute** drops them, **Move** publishes them below another prefix, **Keep** publishes both.',
          'Choose **Play live**. Play, pause, speed, loop and the playhead of this page now control the replay. A jump publishes the last value of each topic at that moment.',
          'Choose **Play on this page only**, or **Stop** in the banner that each other page has. Live records flow again, and muted topics get their last live value back.',
        ],
      },
      { kind: 'link', text: 'Recordings', to: '/recordings' },
      {
        kind: 'text',
        text: 'A replay is a client of the master with the tag `replay`. **Names and timestamps** in the dialog plays topics under other names, so that they meet no live ones.',
      },
      {
        kind: 'code',
        label: 'The same from a file, as a client on any computer that has joined',
        code: 'npm run play -- tuesday.mcap --master {origin} --rename /=/replay --rate 2 --loop',
      },
    ],
  },
  {
    id: 'make-a-ghost',
    title: 'Make a ghost',
    intro:
      'A ghost plays a span of a recording in a loop beside live clients. Several copies stand for a crowd, or load a session.',
    blocks: [
      {
        kind: 'steps',
        steps: [
          'Open a recording and drag on the ruler of the timeline to mark a span.',
          'Open the menu of the span beside **Stop looping**, such as “loop 1.5 s”, and choose **Make a ghost**.',
          'Enter **Copies**, at most 32, and a **Jitter**: the starts of the copies are spread over this time. Choose **Start**.',
          'Recordings lists the ghost under **Replays**. Choose **Stop** there to end it.',
        ],
      },
      { kind: 'link', text: 'Recordings', to: '/recordings' },
      {
        kind: 'text',
        text: 'Each copy is a client with topics of its own. A topic of the recorded client, `/<client id>/…`, becomes one of the copy, `/<id of the copy>/…`; all others get a prefix such as `/ghost-1`. Muxers of sessions therefore count each copy as one more client.',
      },
    ],
  },
  {
    id: 'run-todays-modules',
    title: 'Run today’s modules on a recording',
    intro:
      'A recorded session runs again on its recorded inputs, with the code that its modules have today. You see whether they would have done the same.',
    blocks: [
      {
        kind: 'steps',
        steps: [
          'Change a module in the module editor and save it to the library.',
          'Open a recording that has a session with this module. In **Graph**, choose **Run today’s modules**.',
          'Wait until the run is over. The sentence below says how many outputs differ. Choose an output or a kind of difference; **Go to the next one** moves the playhead to the next one and selects its track, which marks all of them.',
        ],
      },
      { kind: 'link', text: 'Recordings', to: '/recordings' },
      {
        kind: 'text',
        text: 'The run has topics of its own and disturbs no live session. Modules that are not in the library run with their recorded code; the result names them. Inputs and outputs of the run are a recording too, beside the others.',
      },
      {
        kind: 'steps',
        steps: [
          'For a test of one module, drag on the ruler of the timeline to mark a span, open its menu beside **Stop looping**, and choose **Make a test case of a module**.',
          'Choose **Run the case** to run it with today’s code, and **Save as a file** to keep it.',
          'In the module editor, choose **Open a case** and **Run the case** after each change. The first output that differs is shown.',
        ],
      },
      { kind: 'link', text: 'Modules', to: '/modules' },
    ],
  },
];
