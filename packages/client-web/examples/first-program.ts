// Publishes a wave and answers. Run: node --import tsx examples/first-program.ts [url], end: Ctrl+C
import { createClient } from '@ubii/client-web/node';

const client = createClient({
  url: process.argv[2] ?? 'http://localhost:8080',
  name: 'first program',
});
await client.connect();
console.log(`connected as ${client.name}`);

let seen = 0;
client.subscribe('/first-program/lamp', { format: 'bool' }).onRecord(({ value }) => {
  seen += 1;
  console.log(`the lamp is ${value ? 'on' : 'off'}`);
  client.publish('/first-program/seen', 'int32', seen);
});

let step = 0;
const timer = setInterval(() => {
  step += 1;
  client.publish('/first-program/wave', 'double', Math.sin(step / 10));
}, 50);

process.once('SIGINT', () => {
  clearInterval(timer);
  void client.close(); // deregisters; then nothing keeps the process alive
});
