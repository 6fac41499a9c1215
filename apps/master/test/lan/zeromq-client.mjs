// Client of the test network that uses ZeroMQ as existing clients do: registers, subscribes to a topic and publishes on it.
import { Dealer, Request } from 'zeromq';

const { host, services, topicData, from, identity, topic, frame } = JSON.parse(
  process.argv[2] ?? '',
);
const addressOf = (port) => `tcp://${from}:0;${host}:${port}`;
const tell = (seen) => {
  process.stdout.write(JSON.stringify(seen));
  process.exit(0);
};
setTimeout(() => tell({ problem: 'no answer' }), 20_000).unref();

const request = new Request({ linger: 0 });
request.connect(addressOf(services));
async function call(message) {
  await request.send(JSON.stringify(message));
  const [reply] = await request.receive();
  return JSON.parse(reply.toString());
}

const { client, error } = await call({
  topic: '/services/client/registration',
  client: { name: 'existing device' },
});
const id = identity ?? client?.id ?? 'none';
const dealer = new Dealer({ routingId: id, linger: 0 });
dealer.events.on('disconnect', () => tell({ error: error?.code, isRefused: true }));
dealer.connect(addressOf(topicData));
await call({
  topic: '/services/topic_subscription',
  topicSubscription: { clientId: id, subscribeTopics: [topic] },
});
await dealer.send(Buffer.from(frame, 'base64'));
for (;;) {
  const [, content] = await dealer.receive();
  if (content.toString() !== 'PING') tell({ id, frame: content.toString('base64') });
  await dealer.send('PONG');
}
