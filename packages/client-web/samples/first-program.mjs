import { startProgram } from '@ubii/client-web/node';

const [url = 'http://localhost:8080', joinToken] = process.argv.slice(2);
const client = await startProgram({ url, name: 'first program', joinToken });
console.log(`connected as ${client.name}`);

let seen = 0;
client.subscribe('/first-program/lamp', { format: 'bool' }).onRecord(({ value }) => {
  console.log(`the lamp is ${value ? 'on' : 'off'}`);
  client.publish('/first-program/seen', 'int32', ++seen);
});
setInterval(() => client.publish('/first-program/wave', 'double', Math.sin(Date.now() / 500)), 50);
