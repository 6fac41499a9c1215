import type { HowTo } from './how-to.ts';

/** How-tos for tasks with other programs or computers. */
export const PROGRAM_HOW_TOS: readonly HowTo[] = [
  {
    id: 'publish-from-python',
    title: 'Publish and subscribe from Python',
    intro: 'The Python node of Ubi-Interact on PyPI works with this master without changes.',
    blocks: [
      {
        kind: 'code',
        label: 'Install the package',
        code: 'python3 -m venv venv\nvenv/bin/pip install ubii-node-python==0.3.0',
      },
      {
        kind: 'code',
        label: 'first_program.py',
        code: `import asyncio
from ubii.node import Publish, Subscriptions, connect_client

def show(record):
    print("the lamp is", "on" if record.bool else "off")

async def main():
    async with connect_client("{origin}/services/json") as client:
        state = client.protocol.state
        while state.value != state.value.CONNECTED:
            await state.get(predicate=lambda s: s == s.CONNECTED)
        await client[Subscriptions].subscribe_topic("/python/lamp").with_callback(show)
        for step in range(1000):
            await client[Publish].publish({"topic": "/python/wave", "double": step / 100})
            await asyncio.sleep(0.05)

asyncio.run(main())`,
      },
      {
        kind: 'text',
        text: 'Run it with `venv/bin/python first_program.py` and open the topic `/python/wave`. Publish true on `/python/lamp`: the program prints it. Use the address of the services with JSON.',
      },
      {
        kind: 'text',
        text: 'The node opens its WebSocket without TLS (`ws://`), so use an address with `http://`. It cannot present an invitation: run it on the computer of the master.',
      },
      { kind: 'link', text: 'Topics', to: '/topics' },
    ],
  },
  {
    id: 'publish-from-unity',
    title: 'Publish from Unity',
    intro:
      'The Unity node of Ubi-Interact connects with two addresses: one for services, one for topic data.',
    blocks: [
      {
        kind: 'steps',
        steps: [
          'Set the connection of the services to HTTP and its address to `{host}/services/binary`. Requests and replies are protobuf.',
          'Set the connection of the topic data to HTTP, which is a WebSocket, and its address to `{host}`. The node appends its client id to it.',
          'Press Play. The client appears on the Clients page with the name of the node.',
        ],
      },
      {
        kind: 'text',
        text: 'The node collects records for about 25 ms and sends the newest record of each topic as one list. It answers the `PING` of the master automatically.',
      },
      {
        kind: 'text',
        text: 'The Unity node runs modules of a session in frequency mode only, and connects them to topics only: it has no muxers and demuxers.',
      },
      { kind: 'link', text: 'Clients', to: '/clients' },
    ],
  },
  {
    id: 'trust-the-certificate',
    title: 'Trust the certificate',
    intro:
      'Phones allow motion sensors and the camera on secure pages only. Install the certificate authority of this master once, and the browser opens its pages without a warning.',
    blocks: [
      {
        kind: 'steps',
        steps: [
          'Open the page below on the device itself. It shows the steps for the system of the device.',
          'Download the certificate, compare its fingerprint with the one on the page, and install it.',
          'Open the secure address of the master (`https://`).',
        ],
      },
      {
        kind: 'text',
        text: 'The private key of the authority stays in the data directory of the master. Remove the certificate when you no longer use the master.',
      },
      { kind: 'link', text: 'Install the certificate', to: '/connect/certificate' },
    ],
  },
  {
    id: 'run-on-another-machine',
    title: 'Run modules on another computer',
    intro:
      'A node is a program that runs modules for the master, for example on a computer with more cores, or where a failure must not affect the master.',
    blocks: [
      {
        kind: 'steps',
        steps: [
          'Get the project on the other computer.',
          'On this computer, choose **Connect a phone** and create an invitation with the role participant.',
          'Start the node with the address of this master and the code of the invitation.',
        ],
      },
      {
        kind: 'code',
        label: 'Start the node',
        code: 'npm run node -- --master {origin} --join <code> --modules ./my-modules --name kitchen',
      },
      {
        kind: 'text',
        text: 'The folder may hold `.js` files whose default export is a module. Their code is trusted; all other code runs in a sandbox. The invitation is needed once: the node keeps its identity in a file.',
      },
      {
        kind: 'code',
        label: 'my-modules/triple.js',
        code: `export default {
  name: 'triple',
  inputs: { in: 'double' },
  outputs: { out: 'double' },
  mode: { triggerOnInput: {} },
  onProcessing(deltaTimeMs, inputs, state) {
    if (inputs.in) return { outputs: { out: { double: inputs.in.double * 3 } } };
  },
};`,
      },
      {
        kind: 'text',
        text: 'The node appears in the palette of the graph editor. Drop it on a module to run that module there.',
      },
      { kind: 'link', text: 'Modules', to: '/modules' },
    ],
  },
];
