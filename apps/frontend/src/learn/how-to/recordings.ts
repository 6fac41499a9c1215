import type { HowTo } from './how-to.ts';

/** How-tos for recordings: making them, keeping the last minutes, files and other programs. */
export const RECORDING_HOW_TOS: readonly HowTo[] = [
  {
    id: 'record-and-mark',
    title: 'Record and mark moments',
    intro:
      'A recording is one file of the master. It has the records of topics bit for bit, who published them and when, the sessions and clients of that time, and your markers.',
    blocks: [
      {
        kind: 'steps',
        steps: [
          'Open Recordings and choose **Record**.',
          'Choose **Everything**, or **Topics**, **Clients** or **Sessions**. The dialog says how much that is per second. **Limits** has the longest duration and the largest size.',
          'Choose **Record** again. From now on each page says that the recording runs.',
          'To mark a moment, press M or choose **Mark**, on any page and on any phone that has joined. You can type a text afterwards: the moment stays the same.',
          'Choose **Stop recording**. The recording opens on its timeline: Space plays it, ← and → go from record to record of the selected track.',
          'Choose a marker on the timeline to change its text or delete it. M adds one at the playhead.',
        ],
      },
      { kind: 'link', text: 'Recordings', to: '/recordings' },
      {
        kind: 'text',
        text: 'Topics, clients and sessions that appear later are recorded too: with **Everything**, or when a pattern such as `/lab/**` matches their topic. Participants and admins record; players can mark.',
      },
      {
        kind: 'text',
        text: 'Modules and programs mark moments as well: each text that is published to a topic that ends with `/recording/marker` is a marker of all that is recorded.',
      },
      {
        kind: 'code',
        label: 'A marker from a program with the client library',
        code: "client.publish('/lab/recording/marker', 'string', 'ball dropped');",
      },
      {
        kind: 'text',
        text: 'A program can record into a file of its own, on this computer or on another one that has joined. Ctrl-C ends it.',
      },
      {
        kind: 'code',
        label: 'Record from the command line',
        code: 'npm run record -- tuesday.mcap --master {origin} --topics "/lab/**" --seconds 600',
      },
    ],
  },
  {
    id: 'keep-the-last-minutes',
    title: 'Keep the last minutes',
    intro:
      'The flight recorder holds the last minutes of all topics in the memory of the master, so that you can keep what happened before anybody thought of recording it.',
    blocks: [
      {
        kind: 'steps',
        steps: [
          'Press K on any page, or open Recordings and choose **Keep the last** minutes.',
          'Type a name in the message and choose **Save**, or choose **Open** to play the recording. The flight recorder goes on.',
          'To change how many minutes and how much memory it has, and whether it holds images, choose **Settings of the flight recorder**. This is for admins.',
        ],
      },
      { kind: 'link', text: 'Recordings', to: '/recordings' },
      {
        kind: 'text',
        text: 'The settings apply until the master exits. Flags make them permanent: 5 minutes and 64 MiB are the defaults, `off` holds nothing.',
      },
      {
        kind: 'code',
        label: 'Hold 20 minutes from the start',
        code: 'npm start -- --flight-recorder 20 --flight-recorder-mib 256',
      },
      {
        kind: 'text',
        text: 'When the memory is full, the oldest records leave first. Images and other large records take at most half of it while small records need the rest.',
      },
      {
        kind: 'text',
        text: 'A program keeps the last minutes by a service call.',
      },
      {
        kind: 'code',
        label: 'Keep from a script on the computer of the master',
        code: `curl -X POST {origin}/services/json -H 'content-type: application/json' \\
  -d '{"topic": "/services/ubii/flight_recorder_keep", "flightRecorderKeepRequest": {"name": "Alarm"}}'`,
      },
    ],
  },
  {
    id: 'exchange-recordings',
    title: 'Exchange recordings with other programs',
    intro:
      'Recordings are MCAP files with the schemas of their records, so that other programs read them as they are. Tables and XDF files come in and go out.',
    blocks: [
      {
        kind: 'steps',
        steps: [
          'Open a recording. **Download** saves its file, which programs for MCAP open, such as Lichtblick.',
          'For other formats choose **Export**: **CSV** or **Parquet** (a table for each topic), **XDF** for tools of the Lab Streaming Layer, **MCAP** for a part, **Video** for topics with images.',
          'To export a part, drag on the ruler of the timeline, open the menu of the span beside **Stop looping**, such as “loop 1.5 s”, and choose **Export the span**.',
          'To open a file, choose **Open a file**, the folder above the list of Recordings, or drop it there: MCAP of any program, CSV or XDF. It stays on this device until you choose **Upload**.',
        ],
      },
      { kind: 'link', text: 'Recordings', to: '/recordings' },
      {
        kind: 'code',
        label: 'The same from the command line',
        code: `npm run info -- tuesday.mcap
npm run export -- tuesday.mcap --format parquet --out tables
npm run export -- tuesday.mcap --format xdf
npm run import -- eeg.xdf`,
      },
      {
        kind: 'text',
        text: '`info` describes a file, also one of another program; with `--repair` it completes one whose end is missing, such as after a crash. `import` writes a recording that you can upload.',
      },
      {
        kind: 'code',
        label: 'Read a recording in Python',
        code: `# pip install mcap mcap-protobuf-support
from mcap.reader import make_reader
from mcap_protobuf.decoder import DecoderFactory

with open("tuesday.mcap", "rb") as file:
    reader = make_reader(file, decoder_factories=[DecoderFactory()])
    topics = [channel.topic for channel in reader.get_summary().channels.values()]
    values = [topic for topic in topics if not topic.startswith("/recording/")]
    for message in reader.iter_decoded_messages(topics=values):
        print(message.channel.topic, message.message.log_time, message.decoded_message)`,
      },
      {
        kind: 'text',
        text: 'Channels below `/recording/` have markers, clocks, sessions, clients and gaps as JSON.',
      },
      {
        kind: 'code',
        label: 'Read an XDF export in Python',
        code: `# pip install pyxdf
import pyxdf

streams, header = pyxdf.load_xdf("tuesday.xdf")
for stream in streams:
    print(stream["info"]["name"][0], stream["time_stamps"], stream["time_series"])`,
      },
    ],
  },
];
