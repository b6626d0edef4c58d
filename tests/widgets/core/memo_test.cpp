#include "widgets/core/task/memo.h"
#include "engine/core/error.h"

#include <QTest>
#include <atomic>
#include <thread>

using namespace lathelier;

class MemoTest : public QObject {
    Q_OBJECT

private slots:
    void manyAskOneComputes()
    {
        Memo<int> memo;
        std::atomic<int> computed{0};
        std::vector<std::thread> threads;
        std::atomic<int> sum{0};
        for (int i = 0; i < 6; ++i)
            threads.emplace_back([&] {
                sum += *memo.find("seven", {}, [&](const Progress&) {
                    ++computed;
                    std::this_thread::sleep_for(std::chrono::milliseconds(30));
                    return 7;
                });
            });
        for (std::thread& thread : threads) thread.join();
        QCOMPARE(computed.load(), 1);
        QCOMPARE(sum.load(), 42);
    }

    void theNextTakesOverWhenTheFirstIsStopped()
    {
        Memo<int> memo;
        std::stop_source stop;
        std::atomic<bool> begun{false};
        std::thread first([&] {
            try {
                memo.find("key", Progress(stop.get_token(), {}), [&](const Progress& progress) -> int {
                    begun = true;
                    for (;;) {
                        progress.check();
                        std::this_thread::sleep_for(std::chrono::milliseconds(1));
                    }
                });
            } catch (const Cancelled&) {
                return;
            }
        });
        while (!begun) std::this_thread::yield();
        int answer = 0;
        std::thread second([&] { answer = *memo.find("key", {}, [](const Progress&) { return 5; }); });
        stop.request_stop();
        first.join();
        second.join();
        QCOMPARE(answer, 5);
    }

    void aWaiterCanBeStopped()
    {
        Memo<int> memo;
        std::atomic<bool> begun{false}, release{false};
        std::thread first([&] {
            memo.find("key", {}, [&](const Progress&) {
                begun = true;
                while (!release) std::this_thread::sleep_for(std::chrono::milliseconds(1));
                return 1;
            });
        });
        while (!begun) std::this_thread::yield();
        std::stop_source stop;
        std::atomic<bool> cancelled{false};
        std::thread second([&] {
            try {
                memo.find("key", Progress(stop.get_token(), {}), [](const Progress&) { return 2; });
            } catch (const Cancelled&) {
                cancelled = true;
            }
        });
        stop.request_stop();
        second.join();
        QVERIFY(cancelled);
        release = true;
        first.join();
    }

    void oldAnswersAreForgotten()
    {
        Memo<int> memo(2);
        int computed = 0;
        const auto ask = [&](const std::string& key) {
            memo.find(key, {}, [&](const Progress&) { return ++computed; });
        };
        ask("a");
        ask("b");
        ask("a");
        ask("c");  // "b" was used longest ago
        ask("a");
        QCOMPARE(computed, 3);
        ask("b");
        QCOMPARE(computed, 4);
    }

    void whatFailsIsAskedAgain()
    {
        Memo<int> memo;
        QVERIFY_EXCEPTION_THROWN(memo.find("key", {}, [](const Progress&) -> int { throw std::bad_alloc(); }),
                                 std::bad_alloc);
        QCOMPARE(*memo.find("key", {}, [](const Progress&) { return 3; }), 3);
    }
};

QTEST_APPLESS_MAIN(MemoTest)
#include "memo_test.moc"
