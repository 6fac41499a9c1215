import { createServer } from 'node:net';
import { Aedes } from 'aedes';

/* An MQTT broker of Aedes, as its documentation starts one. */
const aedes = await Aedes.createBroker();
const server = createServer({ noDelay: true }, aedes.handle);
server.listen(0, '127.0.0.1', () => {
  process.stdout.write(`${JSON.stringify({ port: server.address().port })}\n`);
});
process.on('SIGTERM', () => process.exit(0));
