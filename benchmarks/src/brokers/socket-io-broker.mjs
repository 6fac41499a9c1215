import { createServer } from 'node:http';
import { Server } from 'socket.io';

/* Passes binary events on to the room of a topic, as applications of Socket.IO do. */
const server = createServer();
const io = new Server(server, { transports: ['websocket'], maxHttpBufferSize: 16 * 1024 * 1024 });
io.on('connection', (socket) => {
  socket.on('subscribe', (topic, done) => {
    if (topic !== '') socket.join(topic);
    done();
  });
  socket.on('record', (topic, bytes) => io.to(topic).emit('record', bytes));
});
server.listen(0, '127.0.0.1', () => {
  process.stdout.write(`${JSON.stringify({ port: server.address().port })}\n`);
});
process.on('SIGTERM', () => process.exit(0));
