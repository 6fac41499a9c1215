// Registers a device, and finds it by what it is. Run: node --import tsx examples/device.ts [url]
import { createClient } from '@ubii/client-web/node';

const url = process.argv[2] ?? 'http://localhost:8080';
const phone = createClient({ url, name: 'phone' });
const screen = createClient({ url, name: 'screen' });
await Promise.all([phone.connect(), screen.connect()]);

// The screen asks for every touch in the room, of devices that come later as well.
const touches = screen.subscribe({ component: { tags: ['touch'] } }, { format: 'vector2' });
await touches.ready;

// A component is one stream of data. Its topic is /<client id>/<device>/<component> unless you say.
const device = await phone.registerDevice({
  name: 'smart device',
  components: [
    { name: 'touch', format: 'vector2', tags: ['touch'] },
    { name: 'vibration', format: 'double', ioType: 'subscriber' },
  ],
});

// By the component's name the compiler knows the type of the value.
const vibrations = device.component('vibration').subscribe();
await vibrations.ready;
device.component('touch').publish({ x: 0.25, y: 0.75 });

for await (const { topic, value } of touches) {
  console.log(`touched at ${value.x}, ${value.y}`);
  const [, clientId] = topic.split('/');
  screen.publish(`/${clientId}/smart device/vibration`, 'double', 1);
  break;
}
for await (const { value } of vibrations) {
  console.log(`vibrates with ${value}`);
  break;
}

await device.close(); // closing the client does this, too
await Promise.all([phone.close(), screen.close()]);
